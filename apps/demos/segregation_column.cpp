// Kinetic sieving: grains of four sizes in a column that is sheared evenly. The fine sink, the coarse rise.
//
//   (Phi_k)_t + (W Phi_k (1 - s_h/s_k))_z = 0,   1/s_h = sum_k Phi_k/s_k,   k = 1..4       Eqs. (G2), (G3)
//
// Fronts start at the base and at the surface of a mixture, cross, merge, and come to rest as interfaces
// between pure layers. This is known exactly for any number of sizes (exact_fronts.hpp), and the scheme is
// held to it.
#include "exact_fronts.hpp"
#include "output.hpp"

#include <scree/box.hpp>
#include <scree/grainsize/segregation.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

using namespace scree;

namespace {

const std::vector<double> sizes{0.25e-3, 0.5e-3, 0.75e-3, 1e-3};     // s_k [m]
const std::vector<double> shares{0.3125, 0.1875, 0.1875, 0.3125};    // Phi_k at the start [-], for which
const std::vector<double> invariants{0.375e-3, 0.625e-3, 0.875e-3};  // the sigma_j lie halfway [m]
constexpr double height = 0.1;                                       // [m]
constexpr double shear_rate_everywhere = 10;                         // [1/s]
constexpr double strength = 1e-3;                                    // of the sieving [m]
constexpr double frame = 0.1;                                        // [s], of the picture
constexpr Index num_frames = 300;
constexpr Index num_cells = 200;
constexpr double dz = height / num_cells;

/// Adds the mean sizes of all cells [m] to those of earlier times.
void add_mean_sizes(const std::vector<double>& phi, std::vector<double>& all) {
  for (auto here = phi.begin(); here != phi.end(); here += static_cast<std::ptrdiff_t>(sizes.size())) {
    all.push_back(std::inner_product(sizes.begin(), sizes.end(), here, 0.0));
  }
}

/// The mean over the height of |mean size - exact| [m], over the cells of the latest time.
double error_of(std::span<const double> mean_sizes, const demo::ExactColumn& exact) {
  double error = 0;
  for (double z = 0; const double size : mean_sizes) {
    const double integral = integral_of_mean_size(exact, z + dz) - integral_of_mean_size(exact, z);
    error += std::abs(size * dz - integral) / height;
    z += dz;
  }
  return error;
}

}  // namespace

int main(int argc, char** argv) {
  const auto folder = demo::folder_from(argc, argv);
  const Lattice<1> cells = box<1>({0}, {height}, {num_cells}).cells();
  std::vector<double> phi;  // num_cells x num_classes, class fastest
  for (Index i = 0; i < num_cells; ++i) phi.insert(phi.end(), shares.begin(), shares.end());

  const grainsize::SegregationOptions options{.closure = grainsize::Gravity{strength}};
  const Vector<1> down{-1.0};
  grainsize::Segregation<1> scheme{grainsize::SizeClasses{sizes}, options, cells, down, Threads{1}};
  const std::vector<double> masses(num_cells, 1.0);
  const std::vector<double> drive(num_cells, shear_rate_everywhere);
  demo::ExactColumn exact = demo::exact_column(sizes, invariants, height, strength * shear_rate_everywhere);

  std::vector<double> mean_sizes;
  demo::Column times{"time", {}};
  demo::Column fronts{"front", {}};
  double largest_error = 0;
  for (int n = 1; n <= num_frames; ++n) {
    scheme.advance(masses, drive, phi, frame);
    advance(exact, frame);

    add_mean_sizes(phi, mean_sizes);
    largest_error = std::max(largest_error, error_of(std::span{mean_sizes}.last(num_cells), exact));
    times.values.insert(times.values.end(), exact.fronts.size(), n * frame);
    for (const demo::Front& front : exact.fronts) fronts.values.push_back(front.z);
  }
  demo::write_table(folder / "segregation_fronts.csv", {times, fronts});
  const auto picture = box<2>({0, 0}, {height, num_frames * frame}, {num_cells, num_frames});
  demo::write_plane(folder / "segregation_column.csv", picture.cells(), mean_sizes);

  double drift = 0;  // of the share of a size in the whole column
  for (std::size_t k = 0; k < sizes.size(); ++k) {
    double share = 0;
    for (std::size_t i = k; i < phi.size(); i += sizes.size()) share += phi[i] / num_cells;
    drift = std::max(drift, std::abs(share - shares[k]));
  }
  const auto [low, high] = std::ranges::minmax(phi);
  std::printf("%zu interfaces in the end  error up to %.4f mm  shares from %.0e to %.6f, mean off by %.0e\n",
              exact.fronts.size(), 1e3 * largest_error, low, high, drift);
  // A jump smeared to a straight ramp over ten cells leaves an error of jump x 10 dz/4, and all jumps add up
  // to the difference of the largest and the smallest size.
  const double bound = (sizes.back() - sizes.front()) / 4 * 10 / num_cells;
  return largest_error < bound && low > -1e-14 && high < 1 + 1e-14 && drift < 1e-12 ? 0 : 1;
}
