#include "concat.hpp"
#include "stored_frame.hpp"

#include <scree/error.hpp>
#include <scree/io/frame_reader.hpp>
#include <scree/io/hdf5/file.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace scree::io {

FrameReader::FrameReader(std::filesystem::path directory) : directory_{std::move(directory)} {
  const Hdf5File run = Hdf5File::open(directory_ / "run.h5");
  for (const std::string& name : run.children("/frames")) {
    frames_.push_back(detail::read_stored_frame(directory_, name));
  }
  std::ranges::stable_sort(frames_, {}, &StoredFrame::step);
}

const StoredFrame& FrameReader::nearest(double time) const {
  require(!std::isnan(time), "a time to look for must be a number");
  require(!frames_.empty(), (directory_ / "run.h5").string() + ": holds no frames yet");
  return *std::ranges::min_element(frames_, {},
                                   [time](const StoredFrame& frame) { return std::abs(frame.time - time); });
}

std::vector<double> FrameReader::read(const StoredFrame& frame, std::string_view name) const {
  const std::filesystem::path path = directory_ / frame.file();
  const auto is_it = [name](const StoredColumn& column) { return column.quantity.name == name; };
  if (std::ranges::none_of(frame.columns, is_it)) {
    std::vector<std::string_view> names;
    for (const StoredColumn& column : frame.columns) names.emplace_back(column.quantity.name);
    throw InputError{detail::concat(
        {path.string(), ": has no column '", name, "', it has ", detail::joined(names, ", ")})};
  }
  return Hdf5File::open(path).read_doubles(detail::concat({"/", name}));
}

}  // namespace scree::io
