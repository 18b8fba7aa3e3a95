#include <scree/error.hpp>
#include <scree/transport/grids/gmsh.hpp>

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <unordered_map>
#include <utility>

namespace scree::transport {
namespace {

/// Words of the input one by one, and where they stand.
class Words {
 public:
  Words(std::istream& input, std::string_view file) : input_{input}, file_{file} {}

  [[noreturn]] void fail(const std::string& found, std::string_view expected) const {
    std::ostringstream text;
    text << file_ << ':' << line_ << ": found " << found << ", expected " << expected;
    throw InputError{text.str()};
  }

  /// The next word; empty at the end of the input.
  std::string next() {
    int c = input_.get();
    for (; c != end && is_space(c); c = input_.get()) {
      if (c == '\n') ++line_;
    }
    std::string word;
    for (; c != end && !is_space(c); c = input_.get()) word.push_back(static_cast<char>(c));
    if (c != end) input_.unget();
    return word;
  }

  /// What stands between the next two quotation marks.
  std::string quoted(std::string_view expected) {
    std::string name = next();
    if (name.empty() || name.front() != '"') fail(name.empty() ? "the end" : name, expected);
    name.erase(0, 1);
    while (name.empty() || name.back() != '"') {
      const int c = input_.get();
      if (c == end || c == '\n') fail("\"" + name, expected);
      name.push_back(static_cast<char>(c));
    }
    name.pop_back();
    return name;
  }

  template <class Number>
  Number number(std::string_view expected) {
    const std::string word = next();
    if (word.empty()) fail("the end", expected);
    std::istringstream text{word};
    Number value{};
    if (!(text >> value) || text.peek() != end) fail("\"" + word + "\"", expected);
    return value;
  }

  Index count(std::string_view expected) {
    const auto value = number<Index>(expected);
    if (value < 0) fail(std::to_string(value), expected);
    return value;
  }

  void skip(Index count, std::string_view expected) {
    for (Index i = 0; i < count; ++i) {
      if (next().empty()) fail("the end", expected);
    }
  }

  void expect(std::string_view expected) {
    const std::string word = next();
    if (word != expected) fail(word.empty() ? "the end" : "\"" + word + "\"", expected);
  }

 private:
  static constexpr int end = std::char_traits<char>::eof();
  static bool is_space(int c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

  std::istream& input_;
  std::string_view file_;
  int line_ = 1;
};

constexpr int line_element = 1;
constexpr int triangle_element = 2;
constexpr int quadrilateral_element = 3;
constexpr int point_element = 15;

class GmshReader {
 public:
  GmshReader(std::istream& input, std::string_view file) : words_{input, file} {}

  PolygonalMesh read() {
    read_format();
    bool has_nodes = false;
    bool has_elements = false;
    for (std::string section = words_.next(); !section.empty(); section = words_.next()) {
      if (section == "$PhysicalNames") {
        read_physical_names();
      } else if (section == "$Entities") {
        read_entities();
      } else if (section == "$Nodes") {
        read_nodes();
        has_nodes = true;
      } else if (section == "$Elements") {
        if (!has_nodes) words_.fail("$Elements", "$Nodes before them");
        read_elements();
        has_elements = true;
      } else {
        skip_section(section);
      }
    }
    if (!has_elements) words_.fail("the end", "$Elements");
    if (mesh_.num_cells() == 0) words_.fail("the end", "triangles or quadrilaterals among the elements");
    return std::move(mesh_);
  }

 private:
  void read_format() {
    words_.expect("$MeshFormat");
    const std::string version = words_.next();
    if (version != "4.1")
      words_.fail("format \"" + version + "\"", "format 4.1 (Gmsh: Mesh.MshFileVersion = 4.1)");
    if (words_.number<int>("0 for ASCII") != 0) words_.fail("binary data", "ASCII (Gmsh: Mesh.Binary = 0)");
    words_.skip(1, "the size of a number");
    words_.expect("$EndMeshFormat");
  }

  void read_physical_names() {
    const Index count = words_.count("the number of physical names");
    for (Index i = 0; i < count; ++i) {
      const int dimension = words_.number<int>("the dimension of a physical group");
      const int tag = words_.number<int>("the number of a physical group");
      const std::string name = words_.quoted("the name of a physical group in quotation marks");
      if (dimension == 1) group_names_[tag] = name;
    }
    words_.expect("$EndPhysicalNames");
  }

  /// Only the physical groups of curves are of interest.
  void read_entities() {
    constexpr std::string_view what = "a number of an entity";
    std::array<Index, 4> counts{};
    for (Index& count : counts) count = words_.count("the number of entities of each dimension");
    for (std::size_t dimension = 0; dimension < 4; ++dimension) {
      for (Index i = 0; i < counts[dimension]; ++i) {
        const int tag = words_.number<int>("the number of an entity");
        words_.skip(dimension == 0 ? 3 : 6, what);
        const Index num_groups = words_.count("the number of physical groups of an entity");
        if (dimension == 1 && num_groups > 1) {
          words_.fail(
              "curve " + std::to_string(tag) + " in " + std::to_string(num_groups) + " physical groups",
              "one at most");
        }
        for (Index group = 0; group < num_groups; ++group) {
          const int number = std::abs(words_.number<int>("the number of a physical group"));
          if (dimension == 1) group_of_curve_[tag] = number;
        }
        if (dimension > 0) words_.skip(words_.count("the number of bounding entities"), what);
      }
    }
    words_.expect("$EndEntities");
  }

  void read_nodes() {
    const Index num_blocks = words_.count("the number of blocks of nodes");
    const Index num_nodes = words_.count("the number of nodes");
    words_.skip(2, "the range of the nodes");
    for (Index block = 0; block < num_blocks; ++block) {
      const auto dimension = words_.count("the dimension of an entity");
      words_.skip(1, "the number of an entity");
      const bool is_parametric = words_.number<int>("0 or 1 for parametric") != 0;
      const Index count = words_.count("the number of nodes of a block");
      std::vector<Index> tags;
      for (Index i = 0; i < count; ++i) tags.push_back(words_.number<Index>("the number of a node"));
      for (Index i = 0; i < count; ++i) {
        const double x = words_.number<double>("a coordinate");
        const double y = words_.number<double>("a coordinate");
        const double z = words_.number<double>("a coordinate");
        if (z != 0) words_.fail("z = " + std::to_string(z), "a plane mesh: z = 0");
        if (is_parametric) words_.skip(dimension, "a parametric coordinate");
        if (!vertices_.emplace(tags[static_cast<std::size_t>(i)], static_cast<Index>(mesh_.vertices.size()))
                 .second) {
          words_.fail("node " + std::to_string(tags[static_cast<std::size_t>(i)]) + " a second time",
                      "each node once");
        }
        mesh_.vertices.emplace_back(x, y);
      }
    }
    if (num_nodes != static_cast<Index>(mesh_.vertices.size())) {
      words_.fail(std::to_string(mesh_.vertices.size()) + " nodes", std::to_string(num_nodes));
    }
    words_.expect("$EndNodes");
  }

  void read_elements() {
    const Index num_blocks = words_.count("the number of blocks of elements");
    words_.skip(3, "the number and the range of the elements");
    for (Index block = 0; block < num_blocks; ++block) {
      words_.skip(1, "the dimension of an entity");
      const int entity = words_.number<int>("the number of an entity");
      const int type = words_.number<int>("the type of the elements of a block");
      const Index count = words_.count("the number of elements of a block");
      if (type == point_element) {
        words_.skip(2 * count, "an element and its node");
      } else if (type == line_element) {
        read_lines(entity, count);
      } else if (type == triangle_element || type == quadrilateral_element) {
        for (Index i = 0; i < count; ++i) mesh_.add_cell(read_element(type == triangle_element ? 3 : 4));
      } else {
        words_.fail("elements of type " + std::to_string(type),
                    "points (15), lines (1), triangles (2) or quadrilaterals (3)");
      }
    }
    words_.expect("$EndElements");
  }

  void read_lines(int curve, Index count) {
    const auto group = group_of_curve_.find(curve);
    for (Index i = 0; i < count; ++i) {
      const std::vector<Index> ends = read_element(2);
      if (group != group_of_curve_.end())
        mesh_.boundary_edges.push_back({ends[0], ends[1], boundary(group->second)});
    }
  }

  /// The vertices of an element.
  std::vector<Index> read_element(int num_nodes) {
    words_.skip(1, "the number of an element");
    std::vector<Index> polygon;
    for (int i = 0; i < num_nodes; ++i) {
      const auto tag = words_.number<Index>("a node of an element");
      const auto vertex = vertices_.find(tag);
      if (vertex == vertices_.end()) words_.fail("node " + std::to_string(tag), "one of the nodes");
      polygon.push_back(vertex->second);
    }
    return polygon;
  }

  /// The place of a physical group's name among the boundaries.
  int boundary(int group) {
    const auto [place, is_new] = boundaries_.emplace(group, static_cast<int>(mesh_.boundary_names.size()));
    if (is_new) {
      const auto name = group_names_.find(group);
      mesh_.boundary_names.push_back(name != group_names_.end() ? name->second : std::to_string(group));
    }
    return place->second;
  }

  void skip_section(const std::string& section) {
    if (section.front() != '$') words_.fail("\"" + section + "\"", "a section, which starts with $");
    const std::string last = "$End" + section.substr(1);
    for (std::string word = words_.next(); word != last; word = words_.next()) {
      if (word.empty()) words_.fail("the end", last);
    }
  }

  Words words_;
  PolygonalMesh mesh_;
  std::map<int, std::string> group_names_;     // of curves
  std::map<int, int> group_of_curve_;          // physical group of an entity
  std::map<int, int> boundaries_;              // place of a physical group in the mesh
  std::unordered_map<Index, Index> vertices_;  // place of a node in the mesh
};

}  // namespace

PolygonalMesh read_gmsh(std::istream& input, std::string_view file) {
  return GmshReader{input, file}.read();
}

PolygonalMesh read_gmsh(const std::filesystem::path& path) {
  std::ifstream input{path};
  if (!input) throw InputError{path.string() + ": cannot be opened"};
  return read_gmsh(input, path.string());
}

}  // namespace scree::transport
