#include "../problems.hpp"
#include "../schemes.hpp"

#include <scree/transport/fluxes/kurganov_tadmor.hpp>
#include <scree/transport/integrators.hpp>

#include <grainsize/column.hpp>
#include <grainsize/exact_solutions.hpp>

#include <algorithm>

namespace scree::charts {
namespace {

using grainsize::SizeClasses, test::Column;

/// A closed column of unit height; `start` and `exact` give the volume of class k below z.
template <class Start, class Exact>
struct ColumnProblem {
  std::string name;
  SizeClasses classes;
  double duration;
  int num_grids;
  Start start;
  Exact exact;
};
template <class Start, class Exact>
ColumnProblem(std::string, SizeClasses, double, int, Start, Exact) -> ColumnProblem<Start, Exact>;

template <class Problem>
void measure(const Problem& problem, const grainsize::SegregationOptions& options, Index num_stages,
             const Effort& effort, Record& record) {
  Column column{problem.classes, record.n, options};
  column.set(problem.start);
  const std::vector<double> start = column.fractions();
  record.cfl = options.cfl;
  record.cpu_seconds = best_cpu_seconds(
      [&] {
        column.fractions() = start;
        record.steps = column.advance(problem.duration).substeps;
      },
      effort);
  record.flux_evaluations = (record.n - 1) * num_stages * record.steps;  // the walls are closed
  record.l1 = column.error(problem.exact);
}

/// Every limiter and integrator; the scheme for coupled fractions has one reconstruction and one flux.
template <class Problem>
std::vector<Record> run_columns(const Problem& problem, const Extent& extent) {
  using Scheme = transport::PiecewiseLinearCommon<transport::Minmod>;
  std::vector<Record> records;
  for (const Index n : doublings(50, problem.num_grids, extent)) {
    transport::for_each_entry(transport::LimiterList{}, [&]<class L>() {
      for_each_variant<L>([&](const L& limiter, const std::string& label) {
        transport::for_each_entry(transport::IntegratorList{}, [&]<class Integrator>() {
          auto options = Column::defaults();
          options.limiter = limiter;
          options.integrator = Integrator{};
          Record record{.problem = problem.name,
                        .scheme = std::string{Scheme::name},
                        .flux = std::string{transport::KurganovTadmor::name},
                        .limiter = label,
                        .integrator = std::string{Integrator::name},
                        .n = n};
          measure(problem, options, static_cast<Index>(Integrator::kept.size()), extent.effort, record);
          records.push_back(record);
        });
      });
    });
  }
  return records;
}

}  // namespace

std::vector<Record> segregation_two_sizes(const Extent& extent) {
  constexpr double ratio = 2;
  constexpr double share = 0.5;
  const double time = 1;
  const test::InvertedColumn exact{ratio, share, time};
  const auto of_two = [](double fines, double z, std::size_t k) { return k == 0 ? fines : z - fines; };
  return run_columns(
      ColumnProblem{"segregation_two_sizes", SizeClasses{{1 / ratio, 1}}, time, 5,
                    [=](double z, std::size_t k) { return of_two(std::max(0.0, z - (1 - share)), z, k); },
                    [=](double z, std::size_t k) { return of_two(exact.below(z), z, k); }},
      extent);
}

std::vector<Record> segregation_five_sizes(const Extent& extent) {
  const std::string time = "1.306204216";
  const test::FrontColumn exact = test::read_front_column("5bin", time);
  return run_columns(ColumnProblem{"segregation_five_sizes", SizeClasses{{0.2, 0.4, 0.6, 0.8, 1}},
                                   std::stod(time), 4, [](double z, std::size_t) { return z / 5; },
                                   [&](double z, std::size_t k) { return exact.below(z, k); }},
                     extent);
}

}  // namespace scree::charts
