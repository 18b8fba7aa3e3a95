// What must hold of any law on any ready-made path. Both lists are those of the library: a new law or path is
// tested by being there.

#include "bearable_shear.hpp"
#include "path_points.hpp"
#include "points.hpp"

#include <scree/error.hpp>
#include <scree/rheology/laws.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <ostream>
#include <tuple>
#include <variant>

namespace scree::rheology {
namespace {

constexpr double duration = 0.1;  // [s]
constexpr double strain = 0.01;   // [-], of a path that imposes strain
constexpr Index num_steps = 40;

/// A law, as a maker of points under some pressure.
struct Subject {
  std::string_view name;
  /// A point at rest with typical parameters, or with a memory of its own.
  std::unique_ptr<PathPoint> (*point)(const std::vector<double>* memory);

  friend void PrintTo(const Subject& subject, std::ostream* stream) { *stream << subject.name; }
};

template <class Law>
[[nodiscard]] std::unique_ptr<PathPoint> point_of(const std::vector<double>* memory) {
  using Point = PathPointOf<Law>;
  constexpr Law law = typical<Law>();
  std::size_t next = 0;
  const auto state = made_of<typename Point::State>(Law::states, [&](const StateColumn& column) {
    return memory == nullptr ? column.initial : memory->at(next++);
  });
  return std::make_unique<Point>(law, 1.001 * law.density, typical_input<Law>(), state);
}

template <class... Laws>
[[nodiscard]] std::vector<Subject> subjects(std::type_identity<std::variant<Laws...>>) {
  return {{Laws::name, &point_of<Laws>}...};
}
[[nodiscard]] std::vector<Subject> every_law() {
  return subjects(std::type_identity<AnyLaw>{});
}

/// rho c^2: what a strain is met by [Pa].
[[nodiscard]] double modulus_of(const PathPoint& point) {
  const double speed = point.stiffness({Tensor<double>{}, point.now.density}).wave_speed;
  return point.now.density * speed * speed;
}

class EveryLawOnEveryPath : public ::testing::TestWithParam<std::tuple<Subject, NamedPath>> {
 protected:
  [[nodiscard]] static std::unique_ptr<PathPoint> point(const std::vector<double>* memory = nullptr) {
    return std::get<0>(GetParam()).point(memory);
  }

  /// The path at the rate that strains by `strain`, or presses as much as a tenth of it would.
  [[nodiscard]] static Controls controls(double sign = 1) {
    const NamedPath& path = std::get<1>(GetParam());
    const double rate = sign * strain / duration;
    return path.controls(path.unit == "Pa/s" ? rate / 10 * modulus_of(*point()) : rate);
  }

  /// What a component may be off by after a path [Pa]: each step meets its stresses within a tolerance, and
  /// makes some 60 roundings of strains.
  [[nodiscard]] static double tolerance(const std::vector<PathRecord>& records) {
    double stress = 0;
    for (const PathRecord& record : records) stress = std::max(stress, largest(record.at.stress));
    return static_cast<double>(records.size()) * 4 * tolerance_of_stress(*point(), stress);
  }
};

INSTANTIATE_TEST_SUITE_P(, EveryLawOnEveryPath,
                         ::testing::Combine(::testing::ValuesIn(every_law()),
                                            ::testing::ValuesIn(named_paths)),
                         [](const auto& entry) {
                           return std::string{std::get<0>(entry.param).name} + "_on_" +
                                  std::string{std::get<1>(entry.param).name};
                         });

TEST_P(EveryLawOnEveryPath, MeetsWhatItImposes) {  // Eq. (R28)
  const auto led = point();
  const Tensor<double> start = led->now.stress;
  const Controls imposed = controls();

  const auto records = drive(*led, imposed, duration, num_steps);

  for (const PathRecord& record : records) {
    const Tensor<double> rate = symmetric_part(record.velocity_gradient);
    for (std::size_t k = 0; k < symmetric_components.size(); ++k) {
      const auto& [name, i, j] = symmetric_components[k];
      const Control& control = imposed.on[k];
      if (control.of == Control::Of::stress_rate) {
        EXPECT_NEAR(record.at.stress(i, j), start(i, j) + control.rate * record.at.time, tolerance(records));
      } else if (record.at.time > 0) {
        EXPECT_DOUBLE_EQ(rate(i, j), control.rate);
      }
    }
    EXPECT_TRUE(std::ranges::all_of(record.at.stress.components, [](double s) { return std::isfinite(s); }));
    EXPECT_TRUE(std::ranges::all_of(record.state, [](double s) { return std::isfinite(s); }));
    EXPECT_TRUE(std::isfinite(record.at.density) && record.at.density > 0);
  }
}

/// The same path with respect to other axes: the same stresses, turned.
TEST_P(EveryLawOnEveryPath, DoesNotKnowTheAxes) {
  const auto here = point();
  const auto turned = point();
  Controls in_turned_axes = controls();
  in_turned_axes.axes = rotation_of_points();

  const auto records = drive(*here, controls(), duration, num_steps);
  const auto turned_records = drive(*turned, in_turned_axes, duration, num_steps);

  for (std::size_t n = 0; n < records.size(); ++n) {
    EXPECT_LE(largest(turned_records[n].at.stress - rotated(records[n].at.stress)), tolerance(records));
  }
}

/// What is stored between two stages is all that the next one needs.
TEST_P(EveryLawOnEveryPath, GoesOnFromAStoredRecord) {
  const std::array stages{Stage{"there", duration, num_steps, controls()},
                          Stage{"back", duration / 2, num_steps, controls(-1)}};
  const auto straight = point();
  drive(*straight, stages);

  const auto stopped = point();
  const PathRecord stored = drive(*stopped, std::span{stages}.first(1)).back();
  const auto reloaded = point(&stored.state);
  reloaded->now = stored.at;
  drive(*reloaded, std::span{stages}.last(1));

  EXPECT_EQ(reloaded->now.stress.components, straight->now.stress.components);
  EXPECT_EQ(reloaded->now.density, straight->now.density);
  EXPECT_EQ(reloaded->state(), straight->state());
}

/// Mean over the later half of a coarse path, when what its sudden start set off has died away, of the
/// largest difference of a stress from that of a finer one [Pa].
[[nodiscard]] double distance(const std::vector<PathRecord>& coarse, const std::vector<PathRecord>& fine) {
  const std::size_t ratio = (fine.size() - 1) / (coarse.size() - 1);
  const std::size_t half = coarse.size() / 2;
  double sum = 0;
  for (std::size_t n = half; n < coarse.size(); ++n) {
    sum += largest(coarse[n].at.stress - fine[ratio * n].at.stress);
  }
  return sum / static_cast<double>(coarse.size() - half);
}

/// Halving the step halves what is left to the answer of shorter ones, if anything is.
TEST_P(EveryLawOnEveryPath, IsOfFirstOrderInTheStep) {
  std::array<std::vector<PathRecord>, 3> records;
  for (std::size_t level = 0; level < records.size(); ++level) {
    records[level] = drive(*point(), controls(), duration, num_steps << level);
  }
  const double coarse = distance(records[0], records[1]);
  const double fine = distance(records[1], records[2]);
  if (coarse <= tolerance(records[2])) return;  // exact

  EXPECT_GE(std::log2(coarse / fine), 0.9) << coarse << ' ' << fine;
}

/// Work per mass of a path and its way back, motion by motion [J/kg]: what a cycle of strain costs.
struct Cycle {
  double work = 0;
  double turnover = 0;  ///< sum of the works of all steps, without sign
};

[[nodiscard]] Cycle there_and_back(PathPoint& point, const Controls& controls) {
  const auto there = drive(point, controls, duration, num_steps);
  Cycle cycle;
  const auto count = [&](const PathRecord& record, double density_before) {
    const double work =
        contract(record.at.stress, record.velocity_gradient) * duration / num_steps / density_before;
    cycle.work += work;
    cycle.turnover += std::abs(work);
  };
  for (std::size_t n = 1; n < there.size(); ++n) count(there[n], there[n - 1].at.density);
  for (std::size_t n = there.size() - 1; n > 0; --n) {
    const double before = point.now.density;
    count(drive(point, by_strain(-1.0 * there[n].velocity_gradient), duration / num_steps, 1).back(), before);
  }
  return cycle;
}

/// Second law: no work is won from a cycle of strain, but for what the pressure at the start had stored, at
/// most p^2/(2 K) per volume with K >= rho c^2/3 (Poisson's ratio not negative), twice that if K grows with
/// p.
TEST_P(EveryLawOnEveryPath, WinsNoWorkFromACycle) {
  const auto led = point();
  const double p = mean_pressure(led->now.stress);
  const double stored = 3 * p * p / modulus_of(*led) / led->now.density;

  const Cycle cycle = there_and_back(*led, controls());

  // Elastic energies in rates are exact up to the strain, and steps forth and back differ by that of a step.
  EXPECT_GE(cycle.work, -stored - strain * cycle.turnover);
}

class EveryLawOnAPath : public ::testing::TestWithParam<Subject> {};
INSTANTIATE_TEST_SUITE_P(, EveryLawOnAPath, ::testing::ValuesIn(every_law()),
                         [](const auto& entry) { return std::string{entry.param.name}; });

/// A shear stress of ten times the pressure: viscous laws flow, those of friction cannot bear it. The driver
/// says so at the first step at which no rates would have led to what is wanted, by a search of its own kind.
TEST_P(EveryLawOnAPath, SaysThatThereIsNoAnswerOnlyWhereThereIsNone) {
  constexpr Index steps_wanted = 400;
  constexpr double dt = 1.0 / steps_wanted;  // [s]
  const auto led = GetParam().point(nullptr);
  const double normal = led->now.stress(1, 1);
  const double wanted = 10 * mean_pressure(led->now.stress);
  Controls controls = simple_shear_at_constant_pressure(0);
  controls.on[first_shear] = stress_rate(wanted);
  std::vector<PathRecord> records;

  const std::string message = message_of<RunError>([&] {
    drive(*led, std::array{Stage{"the test", 1, steps_wanted, controls}}, {}, records);
  });

  const auto wanted_after = [&](Index n) { return wanted * static_cast<double>(n) * dt; };
  const auto num_taken = static_cast<Index>(records.size()) - 1;
  if (num_taken == steps_wanted) {
    EXPECT_NEAR(led->now.stress(0, 1), wanted, tolerance_of_stress(*led, wanted));
  } else {
    EXPECT_LT(bearable_shear(*led, normal, dt), wanted_after(num_taken + 1)) << message;
    EXPECT_EQ(message.rfind("the law '" + std::string{GetParam().name} + "' has no answer in stage 1 ", 0),
              0U);
  }
  // The search is not blind: it finds that what the driver has reached can be borne, half way there.
  const Index half = num_taken / 2;
  const auto sheared = GetParam().point(nullptr);
  if (half > 0) drive(*sheared, controls, static_cast<double>(half) * dt, half);
  EXPECT_GE(bearable_shear(*sheared, normal, dt), wanted_after(half + 1));
}

}  // namespace
}  // namespace scree::rheology
