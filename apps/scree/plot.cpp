#include "scree/plot.hpp"

#include <scree/error.hpp>

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <string>

namespace scree::app {

int plot(const std::string& name, const std::filesystem::path& directory) {
  // Debian's own interpreter: the one that its h5py and matplotlib belong to.
  std::string interpreter = "/usr/bin/python3";
  std::string script = SCREE_PLOT_SCRIPTS "/" + name;
  std::string argument = directory.string();
  const std::array<char*, 4> arguments{interpreter.data(), script.data(), argument.data(), nullptr};
  pid_t child = 0;
  const int error = posix_spawn(&child, interpreter.c_str(), nullptr, nullptr, arguments.data(), environ);
  if (error != 0) throw RunError{"cannot start " + interpreter + ": " + std::strerror(error)};
  int status = 0;
  if (waitpid(child, &status, 0) < 0 || !WIFEXITED(status)) throw RunError{"the plotting script was ended"};
  return WEXITSTATUS(status);
}

}  // namespace scree::app
