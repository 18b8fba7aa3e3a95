#pragma once

#include <scree/grainsize/segregation.hpp>

#include <cmath>
#include <cstddef>
#include <vector>

namespace scree::test {

/// A closed column of height 1 m and mass 1 kg under a constant driver B = 1 m/s upwards, so that time in
/// seconds is W t/H: coarse grains rise.
class Column {
 public:
  /// @param options the closure in it is replaced by the one that makes B constant
  Column(const grainsize::SizeClasses& classes, Index num_cells,
         grainsize::SegregationOptions options = defaults())
      : num_cells_{num_cells},
        num_classes_{classes.size()},
        scheme_{classes, options, lattice(num_cells), Vector<1>::Zero(), Threads{1}},
        masses_(size(), width()),
        drive_(size()),
        fractions_(size() * num_classes_) {
    for (std::size_t i = 0; i < size(); ++i) drive_[i] = -bottom(i) - width() / 2;
  }

  /// The paper's sizes of schemes: driver 1 m/s per unit of the drive's slope, theta = 1.3, SSPRK2.
  [[nodiscard]] static grainsize::SegregationOptions defaults() {
    return {.closure = grainsize::ShearRate{1}, .limiter = transport::Minmod{1.3}};
  }

  [[nodiscard]] static Lattice<1> lattice(Index num_cells) {
    const double dx = 1 / static_cast<double>(num_cells);
    return {
        .count = {num_cells}, .spacing = Vector<1>{dx}, .first = Vector<1>{dx / 2}, .is_periodic = {false}};
  }

  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(num_cells_); }
  [[nodiscard]] double width() const { return 1 / static_cast<double>(num_cells_); }
  [[nodiscard]] double bottom(std::size_t cell) const { return static_cast<double>(cell) * width(); }
  [[nodiscard]] std::vector<double>& masses() { return masses_; }
  [[nodiscard]] std::vector<double>& drive() { return drive_; }
  [[nodiscard]] std::vector<double>& fractions() { return fractions_; }
  [[nodiscard]] double fraction(std::size_t cell, std::size_t k) const {
    return fractions_[cell * num_classes_ + k];
  }

  /// Fills each cell with the average of what a solution says lies below each height.
  template <class Below>  // double(double z, std::size_t k)
  void set(Below&& below) {
    for (std::size_t i = 0; i < size(); ++i) {
      for (std::size_t k = 0; k < num_classes_; ++k) {
        fractions_[i * num_classes_ + k] = average(below, i, k);
      }
    }
  }

  grainsize::SegregationReport advance(double dt) { return scheme_.advance(masses_, drive_, fractions_, dt); }

  /// sum_k integral |Phi_k - exact| dz [-].
  template <class Below>
  [[nodiscard]] double error(Below&& below) const {
    double sum = 0;
    for (std::size_t i = 0; i < size(); ++i) {
      for (std::size_t k = 0; k < num_classes_; ++k) {
        sum += width() * std::abs(fraction(i, k) - average(below, i, k));
      }
    }
    return sum;
  }

  /// sum_i m_i Phi_i^k [kg].
  [[nodiscard]] double class_mass(std::size_t k) const {
    double sum = 0;
    for (std::size_t i = 0; i < size(); ++i) sum += masses_[i] * fraction(i, k);
    return sum;
  }

 private:
  template <class Below>
  [[nodiscard]] double average(Below&& below, std::size_t cell, std::size_t k) const {
    return (below(bottom(cell + 1), k) - below(bottom(cell), k)) / width();
  }

  Index num_cells_;
  std::size_t num_classes_;
  grainsize::Segregation<1> scheme_;
  std::vector<double> masses_;
  std::vector<double> drive_;
  std::vector<double> fractions_;
};

}  // namespace scree::test
