#pragma once

#include <scree/tensor.hpp>

#include <ostream>
#include <string>
#include <vector>

namespace scree::charts {

/// One run of one scheme on one problem: what it costs, and how far it is from the exact solution.
struct Record {
  std::string problem{};
  std::string scheme{};      ///< name of the reconstruction, or "staggered"
  std::string flux{};        ///< name of the numerical flux
  std::string limiter{};     ///< name of the limiter, its parameter in brackets; empty if there is none
  std::string integrator{};  ///< name; empty if the scheme has its own
  Index n = 0;               ///< cells along one axis
  double cfl = 0;            ///< [-]
  int steps = 0;
  Index flux_evaluations = 0;  ///< faces x stages x steps; staggered: sites x steps
  double cpu_seconds = 0;      ///< [s], best of several; NaN if the run failed
  double l1 = 0;               ///< error, in the unit that the problem states; NaN if the run failed
};

/// Writes the titles of the columns, comma-separated.
void write_titles(std::ostream& out);

/// Writes one line for each record, and flushes.
void write_rows(const std::vector<Record>& records, std::ostream& out);

}  // namespace scree::charts
