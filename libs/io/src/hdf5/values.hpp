#pragma once

#include "hdf5/handle.hpp"

#include <scree/io/hdf5/file.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace scree::io::detail {

/// An object of an open file, and what messages call the file.
struct Place {
  hid_t file;
  std::string file_name;
  std::string_view object;

  [[nodiscard]] std::string object_name() const { return std::string{object}; }
};

/// How a value lies in the file and in memory.
struct ValueType {
  hid_t stored;
  hid_t in_memory;
};

/// Text in UTF-8 of any length, as one pointer in memory.
[[nodiscard]] TypeHandle text_type(const std::string& file_name);
[[nodiscard]] ValueType double_type();
[[nodiscard]] ValueType integer_type();

/// Writes a new dataset. @param shape of rank 0: a single value
void write_dataset(const Place& place, const ValueType& type, const Shape& shape, const void* values);
void write_attribute(const Place& place, const std::string& attribute, const ValueType& type,
                     const void* value);

[[nodiscard]] Shape shape_of(const Place& place);
[[nodiscard]] std::vector<double> read_doubles(const Place& place);
[[nodiscard]] std::vector<std::int64_t> read_integers(const Place& place);
[[nodiscard]] std::string read_text(const Place& place);
[[nodiscard]] double read_double(const Place& place, const std::string& attribute);
[[nodiscard]] std::int64_t read_integer(const Place& place, const std::string& attribute);
[[nodiscard]] std::string read_text(const Place& place, const std::string& attribute);

}  // namespace scree::io::detail
