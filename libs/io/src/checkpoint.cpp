#include <scree/error.hpp>
#include <scree/io/checkpoint.hpp>

#include <utility>

namespace scree::io {
namespace {

/// What tells a checkpoint from any other HDF5 file.
constexpr const char* format_name = "scree checkpoint";

}  // namespace

CheckpointWriter::CheckpointWriter(const std::filesystem::path& path, std::int64_t version)
    : file_{Hdf5File::create(path)} {
  file_.write_attribute("/", "format", std::string{format_name});
  file_.write_attribute("/", "version", version);
}

void CheckpointWriter::add(std::string_view name, std::span<const double> values) {
  file_.write(name, values);
}

void CheckpointWriter::add(std::string_view name, std::span<const std::int64_t> values) {
  file_.write(name, values);
}

void CheckpointWriter::add(const std::string& name, double value) {
  file_.write_attribute("/", name, value);
}

void CheckpointWriter::add(const std::string& name, std::int64_t value) {
  file_.write_attribute("/", name, value);
}

void CheckpointWriter::add_text(std::string_view name, const std::string& text) {
  file_.write_text(name, text);
}

void CheckpointWriter::commit() {
  file_.close();
}

Checkpoint::Checkpoint(std::filesystem::path path, Hdf5File file)
    : path_{std::move(path)}, file_{std::move(file)} {}

void Checkpoint::require_length(std::string_view name, Index length) const {
  const Index found = this->length(name);
  require(found == length, path_.string() + ": '" + std::string{name} + "': expected " +
                               std::to_string(length) + " values, found " + std::to_string(found));
}

std::vector<double> Checkpoint::doubles(std::string_view name, Index length) const {
  require_length(name, length);
  return file_.read_doubles(name);
}

std::vector<std::int64_t> Checkpoint::integers(std::string_view name, Index length) const {
  require_length(name, length);
  return file_.read_integers(name);
}

Index Checkpoint::length(std::string_view name) const {
  return file_.shape(name).size();
}

double Checkpoint::number(const std::string& name) const {
  return file_.double_attribute("/", name);
}

std::int64_t Checkpoint::integer(const std::string& name) const {
  return file_.integer_attribute("/", name);
}

std::string Checkpoint::text(std::string_view name) const {
  return file_.read_text(name);
}

bool Checkpoint::contains(std::string_view name) const {
  return file_.contains(name);
}

Checkpoint read_checkpoint(const std::filesystem::path& path, std::int64_t version) {
  Hdf5File file = Hdf5File::open(path);
  require(file.has_attribute("/", "format") && file.text_attribute("/", "format") == format_name,
          path.string() + ": not a checkpoint of scree");
  const std::int64_t found = file.integer_attribute("/", "version");
  require(found == version, path.string() + ": a checkpoint of version " + std::to_string(found) +
                                ", this program reads version " + std::to_string(version));
  return {path, std::move(file)};
}

}  // namespace scree::io
