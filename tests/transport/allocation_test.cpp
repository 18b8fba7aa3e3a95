// Advancing allocates nothing once it has begun, on any kind of grid.

#include "lines.hpp"

#include <scree/transport/grids/occupied_cells.hpp>
#include <scree/transport/grids/polygonal.hpp>
#include <scree/transport/grids/rectangle_mesh.hpp>
#include <scree/transport/laws/euler.hpp>
#include <scree/transport/staggered.hpp>

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {
std::atomic<long> num_allocations{0};

void* allocate(std::size_t size, std::size_t alignment) {
  ++num_allocations;
  void* memory = std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
  if (memory == nullptr) throw std::bad_alloc{};
  return memory;
}

// Not inlined: seen beside a call of new, free() would be taken for a mistake.
[[gnu::noinline]] void release(void* memory) noexcept {
  std::free(memory);
}
}  // namespace

// Every allocation of C++ in this program goes through these.
void* operator new(std::size_t size) {
  return allocate(size, __STDCPP_DEFAULT_NEW_ALIGNMENT__);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  return allocate(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept {
  release(memory);
}
void operator delete(void* memory, std::size_t /*size*/) noexcept {
  release(memory);
}
void operator delete(void* memory, std::align_val_t /*alignment*/) noexcept {
  release(memory);
}
void operator delete(void* memory, std::size_t /*size*/, std::align_val_t /*alignment*/) noexcept {
  release(memory);
}

namespace scree::transport {
namespace {

const Euler<2> gas;

/// A gas at rest with a wave of density in it.
std::vector<double> states(Index num_cells) {
  std::vector<double> u;
  for (Index i = 0; i < num_cells; ++i) {
    const auto state = gas.state(1 + 0.1 * std::sin(0.3 * static_cast<double>(i)), Vector<2>{0.1, 0}, 1);
    u.insert(u.end(), state.begin(), state.end());
  }
  return u;
}

/// What a second advance allocates: in the first the threads are made.
template <class AnySolver>
long allocated_by(AnySolver& solver, Index num_cells) {
  std::vector<double> u = states(num_cells);
  solver.advance(u, 1e-3);
  const long before = num_allocations;
  solver.advance(u, 1e-3);
  return num_allocations - before;
}

TEST(AdvancingAllocatesNothing, OnLattices) {
  const Lattice<2> lattice = test::cube<2>(20);
  for (const int threads : {1, 2}) {
    Solver uniform{Cartesian<2>{lattice}, gas, {.threads = {threads}}};
    EXPECT_EQ(allocated_by(uniform, 400), 0);
    OccupiedCells<2> cells{Cartesian<2>{lattice}};
    cells.set_fill(std::vector<double>(400, 0.5));
    Solver filled{cells, gas, {.threads = {threads}}};
    EXPECT_EQ(allocated_by(filled, 400), 0);
  }
}

TEST(AdvancingAllocatesNothing, OnPolygons) {
  const PolygonalMesh mesh = make_mesh(Rectangle{});
  for (const int threads : {1, 2}) {
    SolverOptions<Polygonal, 4> options{.threads = {threads}};
    const Polygonal grid{mesh};
    for (int i = 0; i < grid.num_boundaries(); ++i) {
      options.boundaries.emplace(grid.boundary_name(i), Reflecting{});
    }
    Solver solver{grid, gas, options};
    EXPECT_EQ(allocated_by(solver, grid.num_cells()), 0);
  }
}

TEST(AdvancingAllocatesNothing, InTheStaggeredScheme) {
  StaggeredSolver solver{test::cube<2>(20), gas, Minmod{}};
  EXPECT_EQ(allocated_by(solver, 400), 0);
}

TEST(AdvancingAllocatesNothing, AndWhatIsAllocatedIsCounted) {
  const long before = num_allocations;
  const std::vector<double> something(10);
  EXPECT_EQ(num_allocations - before, 1);
}

}  // namespace
}  // namespace scree::transport
