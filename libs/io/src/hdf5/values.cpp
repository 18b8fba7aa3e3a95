#include "hdf5/values.hpp"

#include "concat.hpp"

#include <algorithm>
#include <array>

namespace scree::io::detail {
namespace {

std::string dataset_name(const Place& place) {
  return concat({"'", place.object, "'"});
}

std::string attribute_name(const Place& place, const std::string& attribute) {
  return concat({"attribute '", attribute, "' of '", place.object, "'"});
}

const char* describe(H5T_class_t type) {
  if (type == H5T_FLOAT) return "floating-point numbers";
  if (type == H5T_INTEGER) return "integers";
  if (type == H5T_STRING) return "text";
  return "something else";
}

/// An open dataset or attribute: what there is to know before its values are read.
struct Description {
  std::string name;  ///< with the file, for messages
  TypeHandle type;
  SpaceHandle space;

  [[nodiscard]] InputError error(std::string_view message) const {
    return InputError{concat({name, ": ", message})};
  }
  void require_type(H5T_class_t expected) const {
    const H5T_class_t found = H5Tget_class(type.get());
    if (found == expected) return;
    throw error(concat({"expected ", describe(expected), ", found ", describe(found)}));
  }
  void require_one_value() const {
    if (H5Sget_simple_extent_npoints(space.get()) != 1) throw error("expected one value");
  }
};

DatasetHandle open_dataset(const Place& place) {
  DatasetHandle dataset{H5Dopen2(place.file, place.object_name().c_str(), H5P_DEFAULT)};
  if (dataset.is_open()) return dataset;
  throw InputError{concat({place.file_name, ": has no dataset ", dataset_name(place)})};
}

Description describe(const Place& place, const DatasetHandle& dataset) {
  return {.name = concat({place.file_name, ": ", dataset_name(place)}),
          .type = TypeHandle{H5Dget_type(dataset.get())},
          .space = SpaceHandle{H5Dget_space(dataset.get())}};
}

Shape shape_of(const Description& description) {
  const int rank = H5Sget_simple_extent_ndims(description.space.get());
  if (rank < 1 || rank > 2) throw description.error("expected rank 1 or 2");
  std::array<hsize_t, 2> extent{1, 1};
  H5Sget_simple_extent_dims(description.space.get(), extent.data(), nullptr);
  return {
      .num_rows = static_cast<Index>(extent[0]), .num_columns = static_cast<Index>(extent[1]), .rank = rank};
}

/// All values of a dataset whose type is of class `expected`, as `in_memory`.
template <class Number>
std::vector<Number> read_dataset(const Place& place, H5T_class_t expected, hid_t in_memory) {
  const DatasetHandle dataset = open_dataset(place);
  const Description description = describe(place, dataset);
  description.require_type(expected);
  std::vector<Number> values(static_cast<std::size_t>(shape_of(description).size()));
  const herr_t status = H5Dread(dataset.get(), in_memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  if (status < 0) throw description.error("cannot be read");
  return values;
}

/// The value of an attribute whose type is of class `expected`, as `in_memory`.
template <class Value>
Value read_attribute(const Place& place, const std::string& attribute, H5T_class_t expected,
                     hid_t in_memory) {
  // Where the object lies in another file, only its handle keeps that file open.
  const ObjectHandle owner{H5Oopen(place.file, place.object_name().c_str(), H5P_DEFAULT)};
  const AttributeHandle handle{H5Aopen(owner.get(), attribute.c_str(), H5P_DEFAULT)};
  const std::string name = attribute_name(place, attribute);
  if (!handle.is_open()) throw InputError{concat({place.file_name, ": has no ", name})};
  const Description description{.name = concat({place.file_name, ": ", name}),
                                .type = TypeHandle{H5Aget_type(handle.get())},
                                .space = SpaceHandle{H5Aget_space(handle.get())}};
  description.require_type(expected);
  description.require_one_value();
  Value value{};
  if (H5Aread(handle.get(), in_memory, &value) < 0) throw description.error("cannot be read");
  return value;
}

/// Takes a text that HDF5 allocated, and gives it back to HDF5.
std::string take(char* text) {
  std::string result = text == nullptr ? std::string{} : std::string{text};
  H5free_memory(text);
  return result;
}

}  // namespace

TypeHandle text_type(const std::string& file_name) {
  TypeHandle type{H5Tcopy(H5T_C_S1), file_name, "set up HDF5"};
  H5Tset_size(type.get(), H5T_VARIABLE);
  H5Tset_cset(type.get(), H5T_CSET_UTF8);
  return type;
}

ValueType double_type() {
  return {.stored = H5T_IEEE_F64LE, .in_memory = H5T_NATIVE_DOUBLE};
}

ValueType integer_type() {
  return {.stored = H5T_STD_I64LE, .in_memory = H5T_NATIVE_INT64};
}

void write_dataset(const Place& place, const ValueType& type, const Shape& shape, const void* values) {
  const std::string& file = place.file_name;
  const std::string intent = concat({"write ", dataset_name(place)});
  const std::array<hsize_t, 2> extent{static_cast<hsize_t>(shape.num_rows),
                                      static_cast<hsize_t>(shape.num_columns)};
  const SpaceHandle space{
      shape.rank == 0 ? H5Screate(H5S_SCALAR) : H5Screate_simple(shape.rank, extent.data(), nullptr), file,
      intent};
  const PropertiesHandle creation{H5Pcreate(H5P_DATASET_CREATE), file, intent};
  H5Pset_obj_track_times(creation.get(), false);
  const DatasetHandle dataset{H5Dcreate2(place.file, place.object_name().c_str(), type.stored, space.get(),
                                         H5P_DEFAULT, creation.get(), H5P_DEFAULT),
                              file, intent};
  const herr_t status = H5Dwrite(dataset.get(), type.in_memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, values);
  if (status < 0) throw RunError{concat({file, ": cannot ", intent})};
}

void write_attribute(const Place& place, const std::string& attribute, const ValueType& type,
                     const void* value) {
  const std::string& file = place.file_name;
  const std::string intent = concat({"write ", attribute_name(place, attribute)});
  const SpaceHandle space{H5Screate(H5S_SCALAR), file, intent};
  const AttributeHandle handle{
      H5Acreate_by_name(place.file, place.object_name().c_str(), attribute.c_str(), type.stored, space.get(),
                        H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
      file, intent};
  if (H5Awrite(handle.get(), type.in_memory, value) < 0) throw RunError{concat({file, ": cannot ", intent})};
}

Shape shape_of(const Place& place) {
  const DatasetHandle dataset = open_dataset(place);
  return shape_of(describe(place, dataset));
}

std::vector<double> read_doubles(const Place& place) {
  return read_dataset<double>(place, H5T_FLOAT, H5T_NATIVE_DOUBLE);
}

std::vector<std::int64_t> read_integers(const Place& place) {
  return read_dataset<std::int64_t>(place, H5T_INTEGER, H5T_NATIVE_INT64);
}

std::string read_text(const Place& place) {
  const DatasetHandle dataset = open_dataset(place);
  const Description description = describe(place, dataset);
  description.require_type(H5T_STRING);
  description.require_one_value();
  const TypeHandle type = text_type(place.file_name);
  char* text = nullptr;
  const herr_t status = H5Dread(dataset.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, &text);
  if (status < 0) throw description.error("cannot be read");
  return take(text);
}

double read_double(const Place& place, const std::string& attribute) {
  return read_attribute<double>(place, attribute, H5T_FLOAT, H5T_NATIVE_DOUBLE);
}

std::int64_t read_integer(const Place& place, const std::string& attribute) {
  return read_attribute<std::int64_t>(place, attribute, H5T_INTEGER, H5T_NATIVE_INT64);
}

std::string read_text(const Place& place, const std::string& attribute) {
  const TypeHandle type = text_type(place.file_name);
  return take(read_attribute<char*>(place, attribute, H5T_STRING, type.get()));
}

}  // namespace scree::io::detail
