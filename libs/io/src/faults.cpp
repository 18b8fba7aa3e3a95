#include <scree/error.hpp>
#include <scree/io/faults.hpp>

#include <algorithm>
#include <utility>

namespace scree::io {

void Faults::add(int line, std::string message) {
  faults_.push_back({line, std::move(message)});
}

void Faults::throw_if_any() const {
  if (faults_.empty()) return;
  std::vector<Fault> sorted = faults_;
  std::ranges::stable_sort(sorted, [](const Fault& a, const Fault& b) {
    return std::pair{a.line == 0, a.line} < std::pair{b.line == 0, b.line};
  });
  std::string report;
  for (const Fault& fault : sorted) {
    if (!report.empty()) report += '\n';
    report += fault.message;
  }
  throw InputError{report};
}

}  // namespace scree::io
