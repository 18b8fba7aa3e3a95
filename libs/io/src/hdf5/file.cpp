#include "concat.hpp"
#include "hdf5/handle.hpp"
#include "hdf5/values.hpp"

#include <scree/error.hpp>
#include <scree/io/hdf5/file.hpp>

#include <hdf5.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <utility>

namespace scree::io {

using detail::concat;
using detail::FileHandle;
using detail::GroupHandle;
using detail::PropertiesHandle;
using detail::QuietHdf5;

struct Hdf5File::State {
  std::filesystem::path path;
  FileHandle file;
  bool is_writable;

  [[nodiscard]] std::string name() const { return path.string(); }
  [[nodiscard]] detail::Place at(std::string_view object) const {
    return {.file = file.get(), .file_name = name(), .object = object};
  }
};

namespace {

/// Files that live in memory until the library asks for their bytes.
PropertiesHandle in_memory(const std::string& file) {
  constexpr std::size_t growth = 1 << 20;  // [bytes]; the system moves pages, it does not copy them
  PropertiesHandle access{H5Pcreate(H5P_FILE_ACCESS), file, "set up HDF5"};
  H5Pset_fapl_core(access.get(), growth, /*backing_store=*/0);
  return access;
}

/// Refuses, with the reason, what HDF5 would refuse without one.
void require_hdf5(const std::filesystem::path& path) {
  const std::string file = path.string();
  errno = 0;
  std::ifstream stream{path, std::ios::binary};
  stream.peek();
  if (!stream && errno != 0) throw InputError{concat({file, ": cannot be read: ", std::strerror(errno)})};
  if (H5Fis_hdf5(file.c_str()) <= 0) throw InputError{concat({file, ": not an HDF5 file"})};
}

FileHandle open_file(const std::filesystem::path& path, unsigned mode, hid_t access) {
  require_hdf5(path);
  FileHandle file{H5Fopen(path.c_str(), mode, access)};
  if (file.is_open()) return file;
  throw InputError{concat({path.string(), ": a damaged HDF5 file, perhaps cut off"})};
}

/// The name that comes `index`th in the alphabet.
std::string name_in_group(hid_t group, hsize_t index, const std::string& file) {
  const auto get_name = [&](char* name, std::size_t size) {
    return H5Lget_name_by_idx(group, ".", H5_INDEX_NAME, H5_ITER_INC, index, name, size, H5P_DEFAULT);
  };
  const ssize_t length = get_name(nullptr, 0);
  if (length < 0) throw InputError{concat({file, ": cannot read a name"})};
  std::string name(static_cast<std::size_t>(length), '\0');
  get_name(name.data(), name.size() + 1);
  return name;
}

}  // namespace

Hdf5File::Hdf5File(std::unique_ptr<State> state) : state_{std::move(state)} {}
Hdf5File::Hdf5File(Hdf5File&&) noexcept = default;
Hdf5File& Hdf5File::operator=(Hdf5File&&) noexcept = default;
Hdf5File::~Hdf5File() = default;

Hdf5File Hdf5File::create(const std::filesystem::path& path) {
  const QuietHdf5 quiet;
  const std::string name = path.string();
  const PropertiesHandle access = in_memory(name);
  FileHandle file{H5Fcreate(name.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.get()), name, "create it"};
  return Hdf5File{std::make_unique<State>(State{path, std::move(file), true})};
}

Hdf5File Hdf5File::open(const std::filesystem::path& path) {
  const QuietHdf5 quiet;
  return Hdf5File{std::make_unique<State>(State{path, open_file(path, H5F_ACC_RDONLY, H5P_DEFAULT), false})};
}

Hdf5File Hdf5File::append(const std::filesystem::path& path) {
  const QuietHdf5 quiet;
  const PropertiesHandle access = in_memory(path.string());
  return Hdf5File{std::make_unique<State>(State{path, open_file(path, H5F_ACC_RDWR, access.get()), true})};
}

void Hdf5File::close(Durability durability) {
  const QuietHdf5 quiet;
  const std::unique_ptr<State> state = std::move(state_);
  if (!state->is_writable) return;
  const hid_t file = state->file.get();
  void** bytes = nullptr;
  const bool is_whole = H5Fflush(file, H5F_SCOPE_LOCAL) >= 0 &&
                        H5Fget_vfd_handle(file, H5P_DEFAULT, reinterpret_cast<void**>(&bytes)) >= 0;
  const ssize_t size = is_whole ? H5Fget_file_image(file, nullptr, 0) : -1;
  if (size < 0) throw RunError{concat({state->name(), ": cannot be made whole"})};
  replace_file(state->path, {static_cast<const char*>(*bytes), static_cast<std::size_t>(size)}, durability);
}

void Hdf5File::create_group(std::string_view object) {
  const QuietHdf5 quiet;
  const GroupHandle group{
      H5Gcreate2(state_->file.get(), std::string{object}.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
      state_->name(), concat({"make the group '", object, "'"})};
}

void Hdf5File::link_external(std::string_view object, std::string_view target_file,
                             std::string_view target_object) {
  const QuietHdf5 quiet;
  const herr_t status =
      H5Lcreate_external(std::string{target_file}.c_str(), std::string{target_object}.c_str(),
                         state_->file.get(), std::string{object}.c_str(), H5P_DEFAULT, H5P_DEFAULT);
  if (status < 0) throw RunError{concat({state_->name(), ": cannot make the link '", object, "'"})};
}

void Hdf5File::write(std::string_view object, std::span<const double> values, const Shape& shape) {
  SCREE_ASSERT(std::ssize(values) == shape.size());
  const QuietHdf5 quiet;
  detail::write_dataset(state_->at(object), detail::double_type(), shape, values.data());
}

void Hdf5File::write(std::string_view object, std::span<const std::int64_t> values, const Shape& shape) {
  SCREE_ASSERT(std::ssize(values) == shape.size());
  const QuietHdf5 quiet;
  detail::write_dataset(state_->at(object), detail::integer_type(), shape, values.data());
}

void Hdf5File::write(std::string_view object, std::span<const double> values) {
  write(object, values, {.num_rows = std::ssize(values)});
}

void Hdf5File::write(std::string_view object, std::span<const std::int64_t> values) {
  write(object, values, {.num_rows = std::ssize(values)});
}

void Hdf5File::write_text(std::string_view object, const std::string& text) {
  const QuietHdf5 quiet;
  const detail::TypeHandle type = detail::text_type(state_->name());
  const char* const start = text.c_str();
  detail::write_dataset(state_->at(object), {.stored = type.get(), .in_memory = type.get()},
                        {.num_rows = 1, .rank = 0}, &start);
}

void Hdf5File::write_attribute(std::string_view object, const std::string& name, double value) {
  const QuietHdf5 quiet;
  detail::write_attribute(state_->at(object), name, detail::double_type(), &value);
}

void Hdf5File::write_attribute(std::string_view object, const std::string& name, std::int64_t value) {
  const QuietHdf5 quiet;
  detail::write_attribute(state_->at(object), name, detail::integer_type(), &value);
}

void Hdf5File::write_attribute(std::string_view object, const std::string& name, const std::string& value) {
  const QuietHdf5 quiet;
  const detail::TypeHandle type = detail::text_type(state_->name());
  const char* const start = value.c_str();
  detail::write_attribute(state_->at(object), name, {.stored = type.get(), .in_memory = type.get()}, &start);
}

bool Hdf5File::contains(std::string_view object) const {
  const QuietHdf5 quiet;
  const std::string name{object};
  if (name == "/") return true;
  return H5Lexists(state_->file.get(), name.c_str(), H5P_DEFAULT) > 0 &&
         H5Oexists_by_name(state_->file.get(), name.c_str(), H5P_DEFAULT) > 0;
}

bool Hdf5File::has_attribute(std::string_view object, const std::string& name) const {
  const QuietHdf5 quiet;
  return H5Aexists_by_name(state_->file.get(), std::string{object}.c_str(), name.c_str(), H5P_DEFAULT) > 0;
}

std::vector<std::string> Hdf5File::children(std::string_view group) const {
  const QuietHdf5 quiet;
  const GroupHandle handle{H5Gopen2(state_->file.get(), std::string{group}.c_str(), H5P_DEFAULT)};
  if (!handle.is_open()) throw InputError{concat({state_->name(), ": has no group '", group, "'"})};
  H5G_info_t info{};
  H5Gget_info(handle.get(), &info);
  std::vector<std::string> names;
  for (hsize_t i = 0; i < info.nlinks; ++i) names.push_back(name_in_group(handle.get(), i, state_->name()));
  return names;
}

Shape Hdf5File::shape(std::string_view object) const {
  const QuietHdf5 quiet;
  return detail::shape_of(state_->at(object));
}

std::vector<double> Hdf5File::read_doubles(std::string_view object) const {
  const QuietHdf5 quiet;
  return detail::read_doubles(state_->at(object));
}

std::vector<std::int64_t> Hdf5File::read_integers(std::string_view object) const {
  const QuietHdf5 quiet;
  return detail::read_integers(state_->at(object));
}

std::string Hdf5File::read_text(std::string_view object) const {
  const QuietHdf5 quiet;
  return detail::read_text(state_->at(object));
}

double Hdf5File::double_attribute(std::string_view object, const std::string& name) const {
  const QuietHdf5 quiet;
  return detail::read_double(state_->at(object), name);
}

std::int64_t Hdf5File::integer_attribute(std::string_view object, const std::string& name) const {
  const QuietHdf5 quiet;
  return detail::read_integer(state_->at(object), name);
}

std::string Hdf5File::text_attribute(std::string_view object, const std::string& name) const {
  const QuietHdf5 quiet;
  return detail::read_text(state_->at(object), name);
}

}  // namespace scree::io
