#pragma once

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <string>

namespace scree::testing {

/// What a program did.
struct ProgramResult {
  int exit_code;
  std::string output;  ///< and errors
};

/// Runs a program with arguments as a shell splits them.
[[nodiscard]] inline ProgramResult run_program(const std::string& program, const std::string& arguments) {
  const std::string command = program + " " + arguments + " 2>&1";
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return {-1, "cannot start the program"};
  std::string output;
  std::array<char, 4096> buffer{};
  for (std::size_t n = 0; (n = fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
    output.append(buffer.data(), n);
  const int status = pclose(pipe);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, output};
}

}  // namespace scree::testing
