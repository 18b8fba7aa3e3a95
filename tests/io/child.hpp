#pragma once

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <string_view>

namespace scree::io::test {

/// Runs `body` in a process of its own, in which no file can grow beyond `limit` bytes: a disk of which so
/// much is free.  @return true if it returned true
template <class Body>
[[nodiscard]] bool holds_on_full_disk(rlim_t limit, const Body& body) {
  const pid_t child = ::fork();
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limits{.rlim_cur = limit, .rlim_max = limit};
    const bool holds = ::setrlimit(RLIMIT_FSIZE, &limits) == 0 && body();
    ::_exit(holds ? EXIT_SUCCESS : EXIT_FAILURE);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == EXIT_SUCCESS;
}

/// True if `action` throws an Exception with exactly this message.
template <class Exception, class Action>
[[nodiscard]] bool throws(const Action& action, const char* message) {
  try {
    action();
  } catch (const Exception& error) {
    return std::string_view{error.what()} == message;
  }
  return false;
}

}  // namespace scree::io::test
