#include <scree/error.hpp>
#include <scree/io/replace_file.hpp>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>
#include <utility>

namespace scree::io {
namespace {

/// The system's file under a temporary name: closed and removed unless it was moved to its place.
class PartialFile {
 public:
  explicit PartialFile(const std::filesystem::path& path)
      : path_{path.string()}, partial_{path_ + ".partial"} {
    constexpr mode_t readable_by_all = 0666;  // less what the user's umask takes away
    descriptor_ = ::open(partial_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, readable_by_all);
    if (descriptor_ < 0) fail();
  }
  PartialFile(const PartialFile&) = delete;
  PartialFile& operator=(const PartialFile&) = delete;
  PartialFile(PartialFile&&) = delete;
  PartialFile& operator=(PartialFile&&) = delete;
  ~PartialFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!is_moved_) ::unlink(partial_.c_str());
  }

  void write(std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) fail();
      bytes.remove_prefix(static_cast<std::size_t>(written));
    }
  }

  /// Waits until the disk itself has it all.
  void settle() {
    if (::fsync(descriptor_) != 0) fail();
  }

  void move_to_place() {
    if (::close(std::exchange(descriptor_, -1)) != 0) fail();
    if (::rename(partial_.c_str(), path_.c_str()) != 0) fail();
    is_moved_ = true;
  }

 private:
  [[noreturn]] void fail() const { throw RunError{path_ + ": cannot be written: " + std::strerror(errno)}; }

  std::string path_;
  std::string partial_;
  int descriptor_ = -1;
  bool is_moved_ = false;
};

}  // namespace

void replace_file(const std::filesystem::path& path, std::string_view bytes, Durability durability) {
  PartialFile file{path};
  file.write(bytes);
  if (durability == Durability::power_cut) file.settle();
  file.move_to_place();
}

}  // namespace scree::io
