#pragma once

#include <string>
#include <vector>

namespace scree::io {

/// Everything wrong with one input, collected so that a person sees it all at once.
class Faults {
 public:
  /// @param line in the file, 0 for a fault that has none; only orders the faults.
  /// @param message whole, with its place: `scene.toml:14: [rheology] mu_2 = 0.30: must exceed mu_s`.
  void add(int line, std::string message);

  [[nodiscard]] bool is_empty() const noexcept { return faults_.empty(); }

  /// @throws InputError with every fault on a line of its own, in the order of the file and those without a
  /// line last, if there is any.
  void throw_if_any() const;

 private:
  struct Fault {
    int line;
    std::string message;
  };
  std::vector<Fault> faults_;
};

}  // namespace scree::io
