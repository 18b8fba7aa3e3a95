#pragma once

#include <scree/grainsize/closures.hpp>
#include <scree/grainsize/distribution.hpp>
#include <scree/mpm/boundaries.hpp>
#include <scree/mpm/boundaries/contact.hpp>
#include <scree/mpm/carried_cells.hpp>
#include <scree/mpm/cell_means.hpp>
#include <scree/mpm/leaving.hpp>
#include <scree/mpm/order.hpp>
#include <scree/mpm/shapes.hpp>
#include <scree/mpm/time_step.hpp>
#include <scree/mpm/transfers.hpp>
#include <scree/raster.hpp>
#include <scree/rheology/laws.hpp>
#include <scree/rheology/walls.hpp>
#include <scree/transport/integrators.hpp>
#include <scree/transport/limiters.hpp>
#include <scree/triangle_mesh.hpp>

#include <array>
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
  bool is_axisymmetric = false;  ///< x is the radius, from the axis of symmetry; masses are those of a radian
  std::vector<double> size;      ///< edges [m], one per dimension
  Index cells = 0;               ///< along y, the normal of the base
};

/// A wall that resists sliding by a law.
struct FrictionScene {
  rheology::AnyWallLaw law;
  std::vector<double> inputs;  ///< a number per column that the law reads, all over the wall, in its unit
  /// Or, unless empty, the name of a column of the material, one per column that the law reads: then it reads
  /// that, the mean where it holds material.
  std::vector<std::string> of_material;
  mpm::Hold hold = mpm::Hold::pushes;
};

/// An end of an axis without a wall: material flows out.
struct OpenEnd {
  static constexpr std::string_view name = "open";
};

/// One that holds whole components of velocity, one with friction, or none.
using WallScene = std::variant<mpm::AnyWall, FrictionScene, OpenEnd>;

/// The two walls of an axis, or none if it is periodic.
struct AxisScene {
  bool is_periodic = false;
  WallScene low;
  WallScene high;
};

/// How ground and bodies hold material that touches them.
struct ContactScene {
  std::variant<mpm::Sticks, mpm::Slides, rheology::AnyWallLaw> law;
  std::vector<double> inputs;            ///< a number per column that the law reads, in its unit
  std::vector<std::string> of_material;  ///< or, unless empty, the column of the material that it reads
  mpm::Hold hold = mpm::Hold::pushes;
};

/// Where a map lies: maps have x to the east, y to the north, and their heights count from a datum. East is x
/// of the mesh, north z, and up y.
struct MapPlace {
  std::array<double, 2> origin{};  ///< place on the map of the mesh's own origin [m]
  double datum = 0;                ///< height on the map of y = 0 [m]
};

/// A plane through a point.
struct PlaneScene {
  std::vector<double> point;   ///< [m]
  std::vector<double> normal;  ///< into the material, of any length
};
/// Heights over x at equal distances, the first and the last at the ends of the mesh [m].
struct ProfileScene {
  std::vector<double> heights;
};
/// A map of heights, or of what else is told of places.
struct RasterScene {
  Raster heights;  ///< [m], or the unit of what it is
  MapPlace place;
};
/// Triangles, in coordinates of a map.
struct TrianglesScene {
  TriangleMesh triangles;
  MapPlace place;
};

/// The ground inside the mesh.
struct TerrainScene {
  std::variant<PlaneScene, ProfileScene, RasterScene, TrianglesScene> surface;
  ContactScene contact;
  std::optional<RasterScene> friction;  ///< that its law reads, where the map has a value [-]
};

struct BallScene {
  std::vector<double> centre;  ///< [m]
  double radius = 0;           ///< [m]
  bool is_hollow = false;      ///< with material inside
};

/// Where the pivot of a body is at given times: on a straight way between them, at rest before and after.
struct WayScene {
  std::vector<double> times;                ///< [s], increasing; none: the body has a velocity instead
  std::vector<std::vector<double>> places;  ///< along each axis one for each time, the first at the pivot [m]
};

/// A rigid body, at the start where its surface says. From `start` to `stop` it turns about its pivot, and
/// the pivot moves by its velocity; where a way leads the pivot, the times of that say when.
struct BodyScene {
  std::variant<BallScene, PlaneScene, TriangleMesh> surface;
  ContactScene contact;
  std::vector<double> velocity;  ///< of the pivot [m/s]
  WayScene way;                  ///< of the pivot, in place of its velocity
  double angular_velocity = 0;   ///< [rad/s]
  std::vector<double> pivot;     ///< at the start [m]
  std::array<double, 3> axis{};  ///< of the turn, of unit length
  double start = 0;              ///< [s]
  double stop = 0;               ///< [s]
  bool may_overlap = false;      ///< whether it may begin in ground or in another body
};

/// Material between two corners.
struct BoxRegion {
  std::vector<double> low;   ///< [m]
  std::vector<double> high;  ///< [m]
};
/// Material inside a polygon of x and y; in three dimensions a prism along z.
struct PolygonRegion {
  std::vector<double> x;           ///< of its corners [m]
  std::vector<double> y;           ///< [m]
  std::array<double, 2> across{};  ///< from one z to another [m]
};
/// Material between two heights, above the ground.
struct LayerRegion {
  double bottom = 0;  ///< [m]
  double top = 0;     ///< [m]
};
/// Material on the ground, as deep as a map says.
struct ReleaseRegion {
  Raster depths;  ///< [m], measured straight up; none where it is not positive or not known
  MapPlace place;
};
using RegionScene = std::variant<BoxRegion, PolygonRegion, LayerRegion, ReleaseRegion>;

/// Points of another run, as its checkpoint has them.
struct StoredScene {
  std::filesystem::path path;        ///< of the checkpoint
  std::string traits;                ///< of that run, for difference()
  std::vector<double> spacing;       ///< of its mesh [m]
  std::vector<std::string> columns;  ///< names of what its points carry
};

/// Material at rest: a box, or whatever lies in one region or more.
struct MaterialScene {
  std::vector<double> low;                   ///< corners of the box, or of one round all regions [m]
  std::vector<double> high;                  ///< [m]
  std::vector<RegionScene> regions;          ///< none: the box itself
  Index points_per_cell = 3;                 ///< along each axis
  std::optional<std::uint64_t> random_seed;  ///< points lie anywhere in their shares of a cell
  double surface_pressure = 0;               ///< on the top of it [Pa]
  std::optional<StoredScene> stored;         ///< in place of all this, but for the box round them
  bool is_absent = false;                    ///< all that there is enters: the box is round where it does
};

/// A stream that enters through a box, as dense as the law is without pressure.
struct InflowScene {
  std::vector<double> low;        ///< corners of the box [m]
  std::vector<double> high;       ///< [m]
  std::vector<double> velocity;   ///< along one axis of the mesh [m/s]
  Index points_per_cell = 3;      ///< along each axis
  std::vector<double> fractions;  ///< of its grains; none: those of the scene [-]
  double start = 0;               ///< [s]; at the start of a run the box is full
  double stop = 0;                ///< [s]
};

/// Whether the box of a stream is full at the start of a run.
[[nodiscard]] inline bool begins_full(const InflowScene& inflow) noexcept {
  return inflow.start == 0;
}

/// A box that takes away what enters it.
struct OutflowScene {
  std::vector<double> low;   ///< [m]
  std::vector<double> high;  ///< [m]
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
  mpm::Leaving leaving = mpm::Leaving::stop;
  std::optional<TerrainScene> terrain;
  std::vector<BodyScene> bodies;
  MaterialScene material;
  std::vector<InflowScene> inflows;
  std::vector<OutflowScene> outflows;
  GravityScene gravity;
  rheology::AnyLaw law;
  std::vector<InitialScene> initial;
  mpm::AnyShape shape;
  mpm::AnyTransfer transfer;
  mpm::Order order = mpm::Order::usl;
  mpm::Averaging averaging;
  int xpic_order = 0;
  double mass_floor = 1e-10;  ///< mpm::Stages::mass_floor [-]
  mpm::TimeStepOptions time_step;
  ViscosityScheme viscosity = ViscosityScheme::with_stress;
  double end = 0;  ///< simulated time [s]
  std::optional<grainsize::Distribution> grains;
  MixtureScene mixture;
  std::optional<SegregationScene> segregation;
  OutputScene output;
};

/// A file that a scene names.
struct FileOfScene {
  std::filesystem::path name;  ///< as the scene has it
  std::filesystem::path path;  ///< where it was found
};

/// A scene as it was read, with the text that reads as the same one again.
struct ReadScene {
  Scene scene;
  std::string text;
  std::vector<FileOfScene> files;  ///< that the text names
};

/// Reads a scene file.
/// @param overrides "table.key=value", each instead of what the file says
/// @throws InputError with all faults, one on a line: file, line, key, value and what was expected.
[[nodiscard]] ReadScene read_scene(const std::filesystem::path& path,
                                   const std::vector<std::string>& overrides);

/// The same of a text; `name` stands for the file in messages, and files are looked for beside it.
[[nodiscard]] ReadScene parse_scene(const std::string& text, const std::string& name,
                                    const std::vector<std::string>& overrides = {});

}  // namespace scree::app
