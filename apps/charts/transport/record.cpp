#include "record.hpp"

#include <fmt/format.h>

namespace scree::charts {

void write_titles(std::ostream& out) {
  out << "problem,scheme,flux,limiter,integrator,n,cfl,steps,flux_evaluations,cpu_seconds,l1\n";
}

void write_rows(const std::vector<Record>& records, std::ostream& out) {
  for (const Record& r : records) {
    out << fmt::format("{},{},{},{},{},{},{:.6g},{},{},{:.4g},{:.10g}\n", r.problem, r.scheme, r.flux,
                       r.limiter, r.integrator, r.n, r.cfl, r.steps, r.flux_evaluations, r.cpu_seconds, r.l1);
  }
  out.flush();
}

}  // namespace scree::charts
