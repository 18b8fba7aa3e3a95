#include "read_bytes.hpp"

#include <scree/error.hpp>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

namespace scree::io::detail {

std::string read_bytes(const std::filesystem::path& path) {
  errno = 0;
  std::ifstream stream{path, std::ios::binary};
  stream.peek();
  if (!stream && errno != 0) throw InputError{path.string() + ": cannot be read: " + std::strerror(errno)};
  return {std::istreambuf_iterator<char>{stream}, {}};
}

}  // namespace scree::io::detail
