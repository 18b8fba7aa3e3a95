#pragma once

#include <scree/io/hdf5/file.hpp>

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace scree::io {

/// Writes named arrays, numbers and texts to one file, all or nothing: the file of before stays until
/// commit() has brought the new one to the disk, and remains if that fails.
class CheckpointWriter {
 public:
  /// @param version of the set of names and their meaning; read_checkpoint() must be told the same.
  CheckpointWriter(const std::filesystem::path& path, std::int64_t version);

  /// Add one entry; a name is used once.  @throws RunError if it cannot be written.
  void add(std::string_view name, std::span<const double> values);
  void add(std::string_view name, std::span<const std::int64_t> values);
  void add(const std::string& name, double value);
  void add(const std::string& name, std::int64_t value);
  void add_text(std::string_view name, const std::string& text);

  /// Replaces the older checkpoint; nothing can be added after.  @throws RunError, the older one kept.
  void commit();

 private:
  Hdf5File file_;
};

/// An open checkpoint. Every bit is as it was written.
class Checkpoint {
 public:
  /// The array `name`. @param length how many values it must have.
  /// @throws InputError naming the file, the array and what is wrong, if it is absent, of another type or
  /// length.
  [[nodiscard]] std::vector<double> doubles(std::string_view name, Index length) const;
  [[nodiscard]] std::vector<std::int64_t> integers(std::string_view name, Index length) const;
  /// The length of the array `name`.  @throws InputError if it is absent.
  [[nodiscard]] Index length(std::string_view name) const;
  /// One number or text.  @throws InputError if it is absent or of another type.
  [[nodiscard]] double number(const std::string& name) const;
  [[nodiscard]] std::int64_t integer(const std::string& name) const;
  [[nodiscard]] std::string text(std::string_view name) const;
  [[nodiscard]] bool contains(std::string_view name) const;

 private:
  friend Checkpoint read_checkpoint(const std::filesystem::path& path, std::int64_t version);
  Checkpoint(std::filesystem::path path, Hdf5File file);
  void require_length(std::string_view name, Index length) const;

  std::filesystem::path path_;
  Hdf5File file_;
};

/// Opens a checkpoint of CheckpointWriter.
/// @throws InputError naming the file, if it is absent, cut off, not a checkpoint or of another version.
[[nodiscard]] Checkpoint read_checkpoint(const std::filesystem::path& path, std::int64_t version);

}  // namespace scree::io
