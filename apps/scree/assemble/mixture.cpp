#include "scree/assemble/mixture.hpp"

#include "scree/scene/dimensions.hpp"
#include "scree/scene/material_columns.hpp"

#include <scree/rheology/columns.hpp>

#include <algorithm>
#include <string>
#include <type_traits>

namespace scree::app {

Mixture::Mixture(const Scene& scene)
    : initial_{scene.grains->fractions}, of_point_(scene.grains->classes.size()) {
  const grainsize::SizeClasses& classes = scene.grains->classes;
  followers_.push_back({{std::string{grain_size_column}, "s_a", "m"},
                        Weights{classes.diameters().begin(), classes.diameters().end()}});
  if (scene.mixture.coarse_size) {
    followers_.push_back({{std::string{coarse_fraction_column}, "c", "-"},
                          grainsize::coarse_shares(classes, *scene.mixture.coarse_size)});
  }
  if (scene.mixture.packing) {
    const auto& [of_one_size, compaction] = *scene.mixture.packing;
    followers_.push_back({{std::string{maximum_packing_column}, "phi_max", "-"},
                          grainsize::CompressiblePacking{classes, of_one_size, compaction}});
  }
  if (is_read_by_walls(scene, friction_column)) {
    followers_.push_back({{std::string{friction_column}, "mu", "-"}, scene.law});
  }
}

template <int D, int V>
void Mixture::add_to(mpm::Particles<D, V>& particles, const std::vector<double>& fractions) {
  const std::vector<double>& initial = fractions.empty() ? initial_ : fractions;
  const std::size_t column =
      particles.add_column({std::string{fraction_column}, "Phi", "-"}, static_cast<int>(initial.size()));
  for (std::size_t k = 0; k < initial.size(); ++k) {
    double* phi = particles.column(column).component(static_cast<int>(k));
    std::fill(phi, phi + particles.size(), initial[k]);
  }
  for (const Follower& follower : followers_) particles.add_column(follower.quantity, 1);
  update(particles);
}

template <int D, int V>
void Mixture::update(mpm::Particles<D, V>& particles) {
  const mpm::Column& fractions = particles.column(particles.find_column(fraction_column, "the mixture"));
  for (const Follower& follower : followers_) {
    mpm::Column& column = particles.column(particles.find_column(follower.quantity.name, "the mixture"));
    std::visit(
        [&]<class Rule>(const Rule& rule) {
          if constexpr (std::is_same_v<Rule, rheology::AnyLaw>) {
            follow(rule, particles, column);
          } else {
            follow(rule, fractions, column);
          }
        },
        follower.rule);
  }
}

void Mixture::follow(const Weights& weights, const mpm::Column& fractions, mpm::Column& column) {
  double* sum = column.component(0);
  std::fill(sum, sum + column.size(), 0.0);
  for (std::size_t k = 0; k < weights.size(); ++k) {
    const double* phi = fractions.component(static_cast<int>(k));
    for (Index p = 0; p < column.size(); ++p) sum[p] += phi[p] * weights[k];
  }
}

void Mixture::follow(const grainsize::CompressiblePacking& packing, const mpm::Column& fractions,
                     mpm::Column& column) {
  for (Index p = 0; p < column.size(); ++p) {
    for (std::size_t k = 0; k < of_point_.size(); ++k) {
      of_point_[k] = fractions.component(static_cast<int>(k))[p];
    }
    column.component(0)[p] = packing.maximum_fraction(of_point_);
  }
}

template <int D, int V>
void Mixture::follow(const rheology::AnyLaw& any_law, const mpm::Particles<D, V>& particles,
                     mpm::Column& column) {
  const auto follow_law = [&]<class Law>(const Law& law) {
    if constexpr (rheology::HasLocalYieldFriction<Law>) {
      std::vector<const double*> read;
      read.reserve(Law::inputs.size());
      for (const InputColumn& input : Law::inputs) {
        read.push_back(particles.column(particles.find_column(input.name, Law::name)).component(0));
      }
      for (Index p = 0; p < column.size(); ++p) {
        std::size_t next = 0;
        column.component(0)[p] = law.yield_friction(rheology::made_of<typename Law::template Input<double>>(
            Law::inputs, [&](const InputColumn& /*input*/) { return read[next++][p]; }));
      }
    }
  };
  std::visit(follow_law, any_law);
}

#define SCREE_INSTANCE(D, V)                                                        \
  template void Mixture::add_to(mpm::Particles<D, V>&, const std::vector<double>&); \
  template void Mixture::update(mpm::Particles<D, V>&);
SCREE_FOR_EACH_DIMENSION(SCREE_INSTANCE)
#undef SCREE_INSTANCE

}  // namespace scree::app
