#include "concat.hpp"

#include <scree/io/bounds.hpp>
#include <scree/io/xdmf.hpp>

namespace scree::io {

using detail::concat;

namespace {

/// The five characters that mean something to XML, written so that they do not.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char letter : text) {
    switch (letter) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += letter;
    }
  }
  return result;
}

std::string label(const Quantity& quantity, const std::string& suffix = "") {
  std::string result = quantity.name + suffix;
  if (quantity.unit != "-") result += concat({" [", quantity.unit, "]"});
  return escaped(result);
}

/// The dataset of a column, its dimensions as XDMF writes them: "51 3".
std::string dataset(const StoredFrame& frame, const StoredColumn& column) {
  std::string dimensions = std::to_string(frame.num_points);
  if (column.kind != ColumnKind::scalar) dimensions.append(" ").append(std::to_string(column.num_components));
  return concat({R"(<DataItem Format="HDF" NumberType="Float" Precision="8" Dimensions=")", dimensions,
                 R"(">)", frame.file(), ":/", escaped(column.quantity.name), "</DataItem>\n"});
}

/// Component `index` of a column of classes: start, stride and count of the part of its dataset.
std::string class_dataset(const StoredFrame& frame, const StoredColumn& column, Index index) {
  const std::string num_points = std::to_string(frame.num_points);
  return concat({R"(<DataItem ItemType="HyperSlab" Dimensions=")", num_points, R"(">)",
                 R"(<DataItem Format="XML" Dimensions="3 2">0 )", std::to_string(index), " 1 1 ", num_points,
                 " 1</DataItem>\n        ", dataset(frame, column), "      </DataItem>\n"});
}

std::string attribute(std::string_view type, const std::string& name, const std::string& item) {
  return concat({R"(      <Attribute Center="Node" AttributeType=")", type, R"(" Name=")", name,
                 "\">\n        ", item, "      </Attribute>\n"});
}

std::string attributes(const StoredFrame& frame, const StoredColumn& column) {
  if (column.quantity.name == "position") return "";
  switch (column.kind) {
    case ColumnKind::scalar:
      return attribute("Scalar", label(column.quantity), dataset(frame, column));
    case ColumnKind::vector:
      return attribute("Vector", label(column.quantity), dataset(frame, column));
    case ColumnKind::tensor:
      return attribute("Tensor", label(column.quantity), dataset(frame, column));
    case ColumnKind::classes:
      break;
  }
  std::string result;
  for (Index index = 0; index < column.num_components; ++index) {
    result += attribute("Scalar", label(column.quantity, concat({"_", std::to_string(index + 1)})),
                        class_dataset(frame, column, index));
  }
  return result;
}

std::string points(const StoredFrame& frame) {
  const std::string num_points = std::to_string(frame.num_points);
  const StoredColumn position{
      .quantity = {"position", "x", "m"}, .kind = ColumnKind::vector, .num_components = 3};
  return concat({R"(      <Topology TopologyType="Polyvertex" NumberOfElements=")", num_points, "\"/>\n",
                 "      <Geometry GeometryType=\"XYZ\">\n        ", dataset(frame, position),
                 "      </Geometry>\n"});
}

}  // namespace

std::string to_xdmf(std::span<const StoredFrame> frames) {
  std::string result =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<Xdmf Version=\"3.0\">\n<Domain>\n"
      "  <Grid Name=\"run\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
  for (const StoredFrame& frame : frames) {
    result += concat({R"(    <Grid Name=")", frame.name, "\" GridType=\"Uniform\">\n      <Time Value=\"",
                      to_text(frame.time), "\"/>\n", points(frame)});
    for (const StoredColumn& column : frame.columns) result += attributes(frame, column);
    result += "    </Grid>\n";
  }
  return result + "  </Grid>\n</Domain>\n</Xdmf>\n";
}

}  // namespace scree::io
