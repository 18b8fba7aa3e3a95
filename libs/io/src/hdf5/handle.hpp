#pragma once

#include <scree/error.hpp>

#include <hdf5.h>

#include <string>
#include <utility>

namespace scree::io::detail {

/// Keeps HDF5 from printing its errors while it lives, then puts back what was set before.
class QuietHdf5 {
 public:
  QuietHdf5() noexcept {
    H5Eget_auto2(H5E_DEFAULT, &print_, &stream_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  QuietHdf5(const QuietHdf5&) = delete;
  QuietHdf5& operator=(const QuietHdf5&) = delete;
  QuietHdf5(QuietHdf5&&) = delete;
  QuietHdf5& operator=(QuietHdf5&&) = delete;
  ~QuietHdf5() { H5Eset_auto2(H5E_DEFAULT, print_, stream_); }

 private:
  H5E_auto2_t print_ = nullptr;
  void* stream_ = nullptr;
};

/// Owns one HDF5 identifier and closes it with its own function. Move-only.
template <herr_t (*close)(hid_t)>
class Hdf5Handle {
 public:
  Hdf5Handle() noexcept = default;
  /// Takes what an HDF5 call returned, a fault (negative) included: ask is_open().
  explicit Hdf5Handle(hid_t id) noexcept : id_{id} {}
  /// @throws RunError "`file`: cannot `intent`" if HDF5 returned a fault.
  Hdf5Handle(hid_t id, const std::string& file, const std::string& intent) : id_{id} {
    if (id_ < 0) throw RunError{file + ": cannot " + intent};
  }
  Hdf5Handle(Hdf5Handle&& other) noexcept : id_{std::exchange(other.id_, H5I_INVALID_HID)} {}
  Hdf5Handle& operator=(Hdf5Handle&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }
  Hdf5Handle(const Hdf5Handle&) = delete;
  Hdf5Handle& operator=(const Hdf5Handle&) = delete;
  ~Hdf5Handle() {
    if (id_ >= 0) close(id_);
  }

  [[nodiscard]] bool is_open() const noexcept { return id_ >= 0; }
  [[nodiscard]] hid_t get() const noexcept { return id_; }

 private:
  hid_t id_ = H5I_INVALID_HID;
};

using FileHandle = Hdf5Handle<H5Fclose>;
using GroupHandle = Hdf5Handle<H5Gclose>;
using ObjectHandle = Hdf5Handle<H5Oclose>;
using DatasetHandle = Hdf5Handle<H5Dclose>;
using AttributeHandle = Hdf5Handle<H5Aclose>;
using SpaceHandle = Hdf5Handle<H5Sclose>;
using TypeHandle = Hdf5Handle<H5Tclose>;
using PropertiesHandle = Hdf5Handle<H5Pclose>;

}  // namespace scree::io::detail
