#pragma once

#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <string_view>

namespace scree {

/// Anything that scree reports by throwing.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The caller asked for something that cannot be: a value out of range, parts that do not fit.
class InputError : public Error {
 public:
  using Error::Error;
};

/// A computation that started well went wrong: NaN, a particle out of the mesh, a full disk.
class RunError : public Error {
 public:
  using Error::Error;
};

/// Throws InputError with `message` unless `condition`. Write the condition so that NaN fails it.
constexpr void require(bool condition, std::string_view message) {
  if (!condition) throw InputError{std::string{message}};
}

namespace detail {
[[noreturn]] inline void assertion_failed(const char* rule, const char* file, int line) noexcept {
  std::fprintf(stderr, "%s:%d: scree is broken, this must hold: %s\n", file, line, rule);
  std::abort();
}
}  // namespace detail

}  // namespace scree

/// A rule that only a bug in scree can break; checked in debug and sanitizer builds, free otherwise.
#ifdef NDEBUG
#define SCREE_ASSERT(rule) static_cast<void>(0)
#else
#define SCREE_ASSERT(rule) \
  ((rule) ? static_cast<void>(0) : ::scree::detail::assertion_failed(#rule, __FILE__, __LINE__))
#endif
