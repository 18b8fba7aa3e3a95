#include "run.hpp"

#include <fmt/format.h>

#include <cmath>

namespace scree::charts {

void write_titles(std::ostream& out) {
  out << "problem,parameter,method,steps,ratio,applications,cpu_seconds,error\n";
}

void write_rows(const std::vector<Run>& runs, std::ostream& out) {
  for (const Run& r : runs) {
    out << fmt::format("{},{:.6g},{},{},{:.6g},{:.6g},{:.4g},{:.10g}\n", r.problem, r.parameter, r.method,
                       r.steps, r.ratio, r.applications, r.cpu_seconds, r.error);
  }
  out.flush();
}

double relative_l1(const std::vector<double>& values, const std::vector<double>& reference) {
  double difference = 0;
  double size = 0;
  for (std::size_t i = 0; i < reference.size(); ++i) {
    difference += std::abs(values[i] - reference[i]);
    size += std::abs(reference[i]);
  }
  return difference / size;
}

}  // namespace scree::charts
