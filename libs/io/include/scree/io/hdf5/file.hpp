#pragma once

#include <scree/io/replace_file.hpp>
#include <scree/tensor.hpp>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace scree::io {

/// The shape of a dataset of rank 1 (`num_rows`) or 2 (`num_rows x num_columns`, column fastest).
struct Shape {
  Index num_rows = 0;
  Index num_columns = 1;
  int rank = 1;

  [[nodiscard]] constexpr Index size() const noexcept { return num_rows * num_columns; }
  friend bool operator==(const Shape&, const Shape&) = default;
};

/// One open HDF5 file: groups, datasets of doubles or 64-bit integers, texts, and attributes on any of them.
///
/// Objects are named by their path in the file ("/frames/velocity"); "/" is the root group. Whatever cannot
/// be written is a RunError, whatever cannot be read or is not of the type asked for an InputError; both name
/// the file and the object. Two files written by the same calls are the same bytes: no times are stored.
///
/// What is written is gathered in memory and reaches the disk whole, by replace_file(), in close(). The HDF5
/// library would otherwise lose the file to a kill, and it crashes when a write fails on a full disk.
class Hdf5File {
 public:
  /// Starts an empty file, which takes the place of any at `path` in close().
  [[nodiscard]] static Hdf5File create(const std::filesystem::path& path);
  /// Opens for reading.  @throws InputError if there is no such file, or it is cut off or not HDF5.
  [[nodiscard]] static Hdf5File open(const std::filesystem::path& path);
  /// Opens for reading and adding; the file at `path` changes in close().  @throws InputError as open().
  [[nodiscard]] static Hdf5File append(const std::filesystem::path& path);

  Hdf5File(Hdf5File&&) noexcept;
  Hdf5File& operator=(Hdf5File&&) noexcept;
  Hdf5File(const Hdf5File&) = delete;
  Hdf5File& operator=(const Hdf5File&) = delete;
  /// Drops what was written and not closed.
  ~Hdf5File();

  /// Replaces the file at the path by what was written; nothing can be done with it after.
  /// @throws RunError naming the file and the system's reason, for instance a full disk; the file of before
  /// stays as it was.
  void close(Durability durability = Durability::power_cut);

  /// Makes a group; the one that holds it must be there.
  void create_group(std::string_view object);
  /// Makes `object` stand for `target_object` of another file, whose path is relative to this file's folder.
  void link_external(std::string_view object, std::string_view target_file, std::string_view target_object);

  /// Writes a new dataset. @param values shape.size() of them, row by row.
  void write(std::string_view object, std::span<const double> values, const Shape& shape);
  void write(std::string_view object, std::span<const std::int64_t> values, const Shape& shape);
  /// Writes a new dataset of rank 1.
  void write(std::string_view object, std::span<const double> values);
  void write(std::string_view object, std::span<const std::int64_t> values);
  /// Writes a new UTF-8 text of any length, without zero bytes.
  void write_text(std::string_view object, const std::string& text);
  /// Writes a new attribute of an object.
  void write_attribute(std::string_view object, const std::string& name, double value);
  void write_attribute(std::string_view object, const std::string& name, std::int64_t value);
  void write_attribute(std::string_view object, const std::string& name, const std::string& value);

  [[nodiscard]] bool contains(std::string_view object) const;
  [[nodiscard]] bool has_attribute(std::string_view object, const std::string& name) const;
  /// The names in a group, in alphabetical order.
  [[nodiscard]] std::vector<std::string> children(std::string_view group) const;
  [[nodiscard]] Shape shape(std::string_view object) const;
  /// All values of a dataset, row by row.
  [[nodiscard]] std::vector<double> read_doubles(std::string_view object) const;
  [[nodiscard]] std::vector<std::int64_t> read_integers(std::string_view object) const;
  [[nodiscard]] std::string read_text(std::string_view object) const;
  [[nodiscard]] double double_attribute(std::string_view object, const std::string& name) const;
  [[nodiscard]] std::int64_t integer_attribute(std::string_view object, const std::string& name) const;
  [[nodiscard]] std::string text_attribute(std::string_view object, const std::string& name) const;

 private:
  struct State;
  explicit Hdf5File(std::unique_ptr<State> state);

  std::unique_ptr<State> state_;
};

}  // namespace scree::io
