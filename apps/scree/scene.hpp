#pragma once

#include <scree/grainsize/closures.hpp>
#include <scree/grainsize/distribution.hpp>
#include <scree/mpm/boundaries.hpp>
#include <scree/mpm/boundaries/frictional.hpp>
#include <scree/mpm/carried_cells.hpp>
#include <scree/mpm/shapes.hpp>
#include <scree/mpm/time_step.hpp>
#include <scree/mpm/transfers.hpp>
#include <scree/rheology/laws.hpp>
#include <scree/rheology/walls.hpp>
#include <scree/transport/integrators.hpp>
#include <scree/transport/limiters.hpp>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace scree::app {

/// A box of cubic cells. One number, the cells along y, sets the resolution of everything.
struct MeshScene {
  int dimensions = 2;
  int velocity_components = 2;
  std::vector<double> size;  ///< edges [m], one per dimension
  Index cells = 0;           ///< along y, the normal of the base
};

/// A wall that resists sliding by a law.
struct FrictionScene {
  rheology::AnyWallLaw law;
  std::vector<double> inputs;  ///< a number per column that the law reads, all over the wall, in its unit
  mpm::Hold hold = mpm::Hold::pushes;
};

/// One that holds whole components of velocity, or one with friction.
using WallScene = std::variant<mpm::AnyWall, FrictionScene>;

/// The two walls of an axis, or none if it is periodic.
struct AxisScene {
  bool is_periodic = false;
  WallScene low;
  WallScene high;
};

/// A box of material at rest.
struct MaterialScene {
  std::vector<double> low;      ///< [m]
  std::vector<double> high;     ///< [m]
  Index points_per_cell = 3;    ///< along each axis
  double surface_pressure = 0;  ///< on the top of it [Pa]
};

struct GravityScene {
  double magnitude = 9.81;   ///< [m/s^2]
  double slope_degrees = 0;  ///< of the base against the horizontal, down along x
};

/// What a number of the law's memory is at the start.
struct InitialScene {
  std::string column;
  double value = 0;  ///< in the unit of the column
};

/// How densely grains are packed.
struct PackingScene {
  double of_one_size = 0;  ///< solid fraction of grains of one size [-]
  double compaction = 0;   ///< K [-]
};

/// What a law asks of a mix of grains beside its mean size: there if the law reads it.
struct MixtureScene {
  std::optional<double> coarse_size;  ///< of the finest grains that count as coarse [m]
  std::optional<PackingScene> packing;
  double ultimate_fractal_dimension = 2.6;  ///< of the number of grains by size, once all are crushed [-]
};

/// How the grains of neighbouring control volumes change places.
struct SegregationScene {
  grainsize::AnyClosure closure{grainsize::ShearRate{0}};
  double remixing = 0;  ///< D [m^2/s]
  transport::AnyLimiter limiter;
  transport::AnyIntegrator integrator;
  double cfl = 0.5;
  Sites control_volumes = Sites::cells;
  mpm::CarriedMap map = mpm::CarriedMap::exchange;
  Index every = 100;  ///< momentum steps between segregation steps
};

struct OutputScene {
  double every = 0;             ///< between frames [s]
  double checkpoint_every = 0;  ///< between checkpoints [s]
  std::vector<std::string> fields;
};

/// How the viscous part of the stress is advanced.
enum class ViscosityScheme {
  with_stress,  ///< as part of it: explicit
  implicit,     ///< solved for on the nodes
  automatic     ///< implicit where the explicit step would be much shorter
};

/// A run as plain data, checked.
struct Scene {
  std::string title;
  MeshScene mesh;
  std::vector<AxisScene> axes;
  MaterialScene material;
  GravityScene gravity;
  rheology::AnyLaw law;
  std::vector<InitialScene> initial;
  mpm::AnyShape shape;
  mpm::AnyTransfer transfer;
  mpm::TimeStepOptions time_step;
  ViscosityScheme viscosity = ViscosityScheme::with_stress;
  double end = 0;  ///< simulated time [s]
  std::optional<grainsize::Distribution> grains;
  MixtureScene mixture;
  std::optional<SegregationScene> segregation;
  OutputScene output;
};

/// A scene as it was read, with the text that reads as the same one again.
struct ReadScene {
  Scene scene;
  std::string text;
};

/// Reads a scene file.
/// @param overrides "table.key=value", each instead of what the file says
/// @throws InputError with all faults, one on a line: file, line, key, value and what was expected.
[[nodiscard]] ReadScene read_scene(const std::filesystem::path& path,
                                   const std::vector<std::string>& overrides);

/// The same of a text; `name` stands for the file in messages.
[[nodiscard]] ReadScene parse_scene(const std::string& text, const std::string& name,
                                    const std::vector<std::string>& overrides = {});

}  // namespace scree::app
