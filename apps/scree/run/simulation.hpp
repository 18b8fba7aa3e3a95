#pragma once

#include "scree/assemble/crushing.hpp"
#include "scree/assemble/mixture.hpp"
#include "scree/assemble/streams.hpp"
#include "scree/run/coupling.hpp"
#include "scree/scene/scene.hpp"

#include <scree/mpm/step.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace scree::app {

/// Where a run stands in time.
struct Clock {
  double time = 0;      ///< [s]
  double moved = 0;     ///< sum of all steps, which is what bodies count; the time but for round-off [s]
  double first_dt = 0;  ///< the first stable step [s]; 0 before it
  std::int64_t step = 0;
  std::int64_t frame = 1;        ///< the next one that is due, at frame * output.every; number 0 is the start
  double unsegregated_time = 0;  ///< since the last segregation step [s]
  std::int64_t unsegregated_steps = 0;
};

/// What a run counts for its summary.
struct Tally {
  std::array<std::int64_t, mpm::limit_names.size()> steps_by_limit{};
  std::int64_t segregation_steps = 0;
  std::int64_t segregation_substeps = 0;
  double segregation_seconds = 0;  ///< wall clock
  FractionExtremes fractions;
  double first_mass = 0;                   ///< [kg]
  std::vector<double> first_class_masses;  ///< [kg]
};

/// A scene brought to life: material points, their mesh, the parts of a step. One simulation knows nothing of
/// files; run.hpp writes what it does.
template <int D, int V>
class Simulation {
 public:
  /// @throws InputError if parts of the scene do not fit each other.
  Simulation(const Scene& scene, Threads threads);

  /// Advances by one step: the stable one, or what is left until the next frame.
  /// @returns whether a frame is due now.
  /// @throws RunError naming a material point gone wrong, or if the step collapses; InputError past the end.
  bool step();
  /// Readies all that follows from points, blocks and clock, after these were read from a checkpoint.
  /// @throws InputError if waves would grow on them at the next step.
  void resume();
  /// Checks that no wave grows on the points as they are at the next step: for now and then.
  /// @throws RunError naming the key of [numerics], what it may be, and the point that bounds the step.
  void require_stable() const;
  /// What to say of a stream that is blocked, once for each; else nothing.
  [[nodiscard]] std::string take_warning() noexcept { return std::exchange(warning_, {}); }

  [[nodiscard]] bool is_finished() const noexcept;
  /// When the next frame is due [s].
  [[nodiscard]] double next_frame_time() const noexcept;
  /// The stable step as things are, and what bounds it.
  [[nodiscard]] mpm::TimeStep next_step() const;

  [[nodiscard]] const Scene& scene() const noexcept { return scene_; }
  [[nodiscard]] const mpm::Stages<D, V>& stages() const noexcept { return stages_; }
  [[nodiscard]] const CartesianGrid<D>& grid() const noexcept { return state.nodes.grid(); }
  /// Whether grains become finer, so that volume moves between their classes.
  [[nodiscard]] bool is_crushing() const noexcept { return crushing_.has_value(); }
  /// How viscosity is advanced and why, if the scene left that open.
  [[nodiscard]] const std::string& viscosity_note() const noexcept { return viscosity_note_; }
  /// Material points times steps, since this simulation was made.
  [[nodiscard]] double point_updates() const noexcept { return point_updates_; }
  /// Material points that weigh something.
  [[nodiscard]] Index num_points() const noexcept;
  /// What to say if most cells with material hold too few points to carry a stress, or a stream brings too
  /// few; else nothing.
  [[nodiscard]] std::string too_few_points() const;
  /// What bounded the steps of the last segregation; nothing without any since this simulation was made.
  [[nodiscard]] std::optional<SegregationLimit<D>> segregation_limit();
  /// C of every point [-]: the law is ill-posed there if it is positive.
  [[nodiscard]] std::vector<double> stability_numbers() const;
  /// Share of the material points at which the law is ill-posed [-]; nothing if the law cannot tell.
  [[nodiscard]] std::optional<double> ill_posed_share() const;

 private:
  const Scene scene_;
  Threads threads_;
  mpm::Stages<D, V> stages_;
  std::string viscosity_note_;
  std::optional<Mixture> mixture_;
  std::optional<Coupling<D, V>> coupling_;
  std::optional<Crushing<D, V>> crushing_;

  Threads most_threads_;
  double point_updates_ = 0;
  Index num_points_ = 0;
  Index num_passed_ = -1;         // when they were counted
  std::vector<bool> is_blocked_;  // by [[inflow]]: it has been said
  std::string warning_;

  [[nodiscard]] mpm::Inflow<D, V> make_inflow(const InflowScene& inflow) const;
  void pass_material();
  void count_updates();
  void segregate();
  void follow_grains();
  void advance(double dt, mpm::Limit limit);
  void require_progress(const mpm::TimeStep& next);
  [[nodiscard]] std::string instability_now() const;
  void renew_rates();
  void look_for_blocked(std::size_t number);

 public:
  mpm::State<D, V> state;
  Streams<D, V> streams;
  Clock clock;
  Tally tally;
};

}  // namespace scree::app
