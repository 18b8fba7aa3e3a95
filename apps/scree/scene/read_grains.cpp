#include "scree/scene/read_grains.hpp"

#include "scree/scene/choices.hpp"
#include "scree/scene/law_columns.hpp"
#include "scree/scene/material_columns.hpp"

#include <scree/grainsize/maximum_packing.hpp>

#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <string_view>

namespace scree::app {

namespace {

using io::above;
using io::between;
using io::TomlTable;

template <class Maker>
[[nodiscard]] std::optional<grainsize::Distribution> try_distribution(const TomlTable& table,
                                                                      std::string_view key, Maker&& make) {
  try {
    return make();
  } catch (const InputError& error) {
    table.add_fault(key, error.what());
    return std::nullopt;
  }
}

[[nodiscard]] std::optional<double> read_coarse_size(const TomlTable& table, const Scene& scene) {
  constexpr std::string_view key = "coarse_size";
  constexpr std::string_view meaning = "size from which grains are coarse [m]";
  const bool is_bidisperse = scene.grains && scene.grains->classes.size() == 2;
  if (!is_bidisperse) return table.number(key, meaning, above(0));
  const auto& classes = scene.grains->classes;
  const double between_them = classes.edges().empty() ? classes.largest() : classes.edges()[1];
  return table.number_or(between_them, key, meaning, above(0));
}

[[nodiscard]] PackingScene read_packing(const TomlTable& table, const Scene& scene) {
  constexpr std::array<std::string_view, 2> keys{"packing_of_one_size", "compaction"};
  const PackingScene packing{
      table.number(keys[0], "solid fraction of packed grains of one size [-]", io::Bounds{0, 1, true, true}),
      table.number(keys[1], "index K of how they are packed [-]", above(0))};
  if (!table.is_sound(keys[0]) || !table.is_sound(keys[1]) || !scene.grains) return packing;
  try {
    const grainsize::CompressiblePacking model{scene.grains->classes, packing.of_one_size,
                                               packing.compaction};
  } catch (const InputError& error) {
    table.add_fault(keys[1], error.what());
  }
  return packing;
}

}  // namespace

std::optional<grainsize::Distribution> read_grains(const TomlTable& table) {
  const std::string kind =
      table.choice_or("classes", "distribution", "how the sizes are given", names_of(choices::distributions));
  if (kind == "classes" || kind == "histogram") {
    const std::string_view key = kind == "classes" ? "diameters" : "edges";
    const auto sizes = table.numbers(
        key, kind == "classes" ? "representative diameters [m]" : "edges of the classes [m]", above(0));
    const auto fractions = table.numbers("fractions", "shares of the solid volume [-]", between(0, 1));
    if (!table.is_sound(key) || !table.is_sound("fractions")) return std::nullopt;
    if (kind == "histogram") {
      return try_distribution(table, "fractions", [&] { return grainsize::histogram(sizes, fractions); });
    }
    return try_distribution(table, "fractions", [&] {
      grainsize::Distribution distribution{grainsize::SizeClasses{sizes}, fractions};
      constexpr double typed_digits =
          1e-9;  // [-]: fractions are typed with as many; their sum is then made 1
      grainsize::require_fractions(distribution.classes, fractions, typed_digits);
      const double sum = std::accumulate(fractions.begin(), fractions.end(), 0.0);
      for (double& fraction : distribution.fractions) fraction /= sum;
      return distribution;
    });
  }
  const double low = table.number("diameter_min", "lower cut of the sizes [m]", above(0));
  const double high = table.number("diameter_max", "upper cut of the sizes [m]", above(0));
  const auto num_classes =
      static_cast<std::size_t>(table.integer("num_classes", "number of classes", between(1, 16)));
  if (kind == "log_normal") {
    const double median = table.number("median", "median size by volume [m]", above(0));
    const double spread = table.number("spread", "standard deviation of ln(size) [-]", above(0));
    if (std::isnan(low + high + median + spread) || num_classes == 0) return std::nullopt;
    return try_distribution(table, "diameter_max", [&] {
      return grainsize::binned(grainsize::LogNormal{median, spread, low, high}, num_classes);
    });
  }
  const double dimension = table.number("fractal_dimension", "of the number of grains by size [-]", above(0));
  if (std::isnan(low + high + dimension) || num_classes == 0) return std::nullopt;
  return try_distribution(table, "diameter_max", [&] {
    return grainsize::binned(grainsize::PowerLaw{dimension, low, high}, num_classes);
  });
}

MixtureScene read_mixture(const TomlTable& table, const Scene& scene) {
  MixtureScene mixture;
  if (reads(scene.law, coarse_fraction_column)) mixture.coarse_size = read_coarse_size(table, scene);
  if (reads(scene.law, maximum_packing_column)) mixture.packing = read_packing(table, scene);
  if (crushes(scene.law)) {
    mixture.ultimate_fractal_dimension =
        table.number_or(mixture.ultimate_fractal_dimension, "ultimate_fractal_dimension",
                        "of the number of grains by size, once all are crushed [-]", above(0));
  }
  return mixture;
}

}  // namespace scree::app
