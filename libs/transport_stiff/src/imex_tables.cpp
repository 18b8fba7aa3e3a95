#include "arkode_handles.hpp"

#include <array>
#include <numbers>

namespace scree::transport::detail {
namespace {

/// Rows of coefficients as ARKODE takes them: C arrays that it copies and does not write to.
template <std::size_t S>
Table make_table(std::array<double, S> times, std::array<double, S * S> stages, std::array<double, S> weights,
                 std::array<double, S> embedded) {
  constexpr int num_stages = static_cast<int>(S);
  return require_made(Table{ARKodeButcherTable_Create(num_stages, 2, 1, times.data(), stages.data(),
                                                      weights.data(), embedded.data())},
                      "ARKodeButcherTable_Create");
}

constexpr double gamma = 1 - 1 / std::numbers::sqrt2;  // [-] makes both second-order implicit halves L-stable

/// The embedded first-order result takes the first stage alone.  Eq. (T51)
TablePair make_ssp2() {
  return {make_table<2>({gamma, 1 - gamma}, {gamma, 0, 1 - 2 * gamma, gamma}, {0.5, 0.5}, {1, 0}),
          make_table<2>({0, 1}, {0, 0, 1, 0}, {0.5, 0.5}, {1, 0})};
}

/// The embedded first-order result takes the second stage alone.  Eq. (T52)
TablePair make_ars2() {
  constexpr double delta = 1 - 1 / (2 * gamma);
  const std::array<double, 3> times{0, gamma, 1};
  const std::array<double, 3> embedded{0, 1, 0};
  return {make_table<3>(times, {0, 0, 0, 0, gamma, 0, 0, 1 - gamma, gamma}, {0, 1 - gamma, gamma}, embedded),
          make_table<3>(times, {0, 0, 0, gamma, 0, 0, delta, 1 - delta, 0}, {delta, 1 - delta, 0}, embedded)};
}

TablePair load(ARKODE_DIRKTableID implicit_half, ARKODE_ERKTableID explicit_half) {
  return {require_made(Table{ARKodeButcherTable_LoadDIRK(implicit_half)}, "ARKodeButcherTable_LoadDIRK"),
          require_made(Table{ARKodeButcherTable_LoadERK(explicit_half)}, "ARKodeButcherTable_LoadERK")};
}

}  // namespace

TablePair make_tables(ImexMethod method) {
  switch (method) {
    case ImexMethod::ssp2:
      return make_ssp2();
    case ImexMethod::ars2:
      return make_ars2();
    case ImexMethod::ark3:
      return load(ARKODE_ARK324L2SA_DIRK_4_2_3, ARKODE_ARK324L2SA_ERK_4_2_3);
    case ImexMethod::ark4:
      return load(ARKODE_ARK436L2SA_DIRK_6_3_4, ARKODE_ARK436L2SA_ERK_6_3_4);
    case ImexMethod::ark5:
      break;
  }
  return load(ARKODE_ARK548L2SA_DIRK_8_4_5, ARKODE_ARK548L2SA_ERK_8_4_5);
}

}  // namespace scree::transport::detail
