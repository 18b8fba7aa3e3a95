#include "read_bytes.hpp"
#include "words.hpp"

#include <scree/io/esri_ascii.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace scree::io {

namespace {

using detail::Words;

constexpr std::array<std::string_view, 8> keys{"ncols",     "nrows",     "xllcorner", "yllcorner",
                                               "xllcenter", "yllcenter", "cellsize",  "nodata_value"};
using Header = std::map<std::string, double, std::less<>>;

[[nodiscard]] std::string lower(std::string_view word) {
  std::string result{word};
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

/// Keys with their numbers, up to the first word that is a number itself.
[[nodiscard]] Header read_header(Words& words) {
  Header header;
  while (!words.peek().empty() && !Words::to_number(words.peek())) {
    const std::string key = lower(words.next());
    if (std::ranges::find(keys, key) == keys.end()) {
      words.fail(Words::quoted(key) +
                 " is no key of the header, which has ncols, nrows, xllcorner, yllcorner, "
                 "xllcenter, yllcenter, cellsize and nodata_value");
    }
    if (header.contains(key)) words.fail(Words::quoted(key) + " is given twice");
    header[key] = words.number();
  }
  return header;
}

[[nodiscard]] Index read_count(const Header& header, std::string_view key, const Words& words) {
  const double count = header.find(key)->second;
  if (!(count >= 1 && count <= 1e9 && count == std::floor(count))) {
    words.fail_whole(std::string{key} + " must be a whole number from 1 on");
  }
  return static_cast<Index>(count);
}

/// Centre of the cell in the south-west.
[[nodiscard]] Vector<2> read_first(const Header& header, double cell_size, const Words& words) {
  const bool has_corners = header.contains("xllcorner") && header.contains("yllcorner");
  const bool has_centres = header.contains("xllcenter") && header.contains("yllcenter");
  const auto num_places = header.count("xllcorner") + header.count("yllcorner") + header.count("xllcenter") +
                          header.count("yllcenter");
  if (num_places != 2 || !(has_corners || has_centres)) {
    words.fail_whole(
        "the header must have either xllcorner and yllcorner, of the outermost corner, or xllcenter and "
        "yllcenter, "
        "of the outermost cell's centre");
  }
  if (has_centres) return {header.at("xllcenter"), header.at("yllcenter")};
  return {header.at("xllcorner") + cell_size / 2, header.at("yllcorner") + cell_size / 2};
}

}  // namespace

Raster parse_esri_ascii(std::string_view text, const std::string& name) {
  Words words{text, name};
  const Header header = read_header(words);
  for (const std::string_view key : {"ncols", "nrows", "cellsize"}) {
    if (!header.contains(key)) words.fail_whole("the header lacks " + Words::quoted(key));
  }
  Raster raster;
  raster.num_columns = read_count(header, "ncols", words);
  raster.num_rows = read_count(header, "nrows", words);
  raster.cell_size = header.at("cellsize");
  if (!(raster.cell_size > 0 && std::isfinite(raster.cell_size))) {
    words.fail_whole("cellsize must be positive and finite");
  }
  raster.first = read_first(header, raster.cell_size, words);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto found = header.find("nodata_value");
  const double no_data = found == header.end() ? nan : found->second;
  const Index expected = raster.num_columns * raster.num_rows;
  if (expected > static_cast<Index>(text.size())) words.fail_whole("is too short for ncols x nrows values");
  raster.values.assign(static_cast<std::size_t>(expected), nan);
  Index count = 0;
  for (; !words.peek().empty(); ++count) {
    const double value = words.number();
    if (count >= expected || value == no_data) continue;
    const Index row = raster.num_rows - 1 - count / raster.num_columns;
    raster.values[static_cast<std::size_t>(row * raster.num_columns + count % raster.num_columns)] = value;
  }
  if (count != expected) {
    words.fail_whole("holds " + std::to_string(count) + " values, and ncols x nrows is " +
                     std::to_string(expected));
  }
  return raster;
}

Raster read_esri_ascii(const std::filesystem::path& path) {
  return parse_esri_ascii(detail::read_bytes(path), path.string());
}

}  // namespace scree::io
