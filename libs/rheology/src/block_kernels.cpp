// Every law of the list over blocks of points; compiled once per instruction set, see
// cmake/scree_kernels.cmake.

#include "block_kernels.hpp"

#include <scree/rheology/laws.hpp>
#include <scree/update_block.hpp>

#include <algorithm>
#include <experimental/simd>
#include <type_traits>
#include <variant>

namespace scree::rheology::SCREE_INSTRUCTION_SET {

namespace {

/// As many doubles as a law is computed for at once. One by one in the baseline, which builds without
/// optimisation compile too.
template <class Law>
[[nodiscard]] constexpr auto number_of() {
  namespace simd = std::experimental;
  constexpr std::size_t lanes = std::min(simd::native_simd<double>::size(), most_lanes<Law>);
  if constexpr (lanes <= 2) {
    return std::type_identity<double>{};
  } else {
    return std::type_identity<simd::simd<double, simd::simd_abi::deduce_t<double, lanes>>>{};
  }
}

/// Flattened: all that it calls is part of it, so that no copy for this instruction set is left for the
/// linker to choose elsewhere.
template <class Law>
[[gnu::flatten]] BlockStiffness run(const Law& law, const LawBlock<Law>& block, double dt) noexcept {
  return update_block<typename decltype(number_of<Law>())::type>(law, block, dt);
}

template <class... Laws>
[[nodiscard, gnu::flatten]] detail::AnyKernel found(const std::type_info& law,
                                                    std::type_identity<std::variant<Laws...>> /*list*/) {
  detail::AnyKernel kernel = nullptr;
  const auto try_law = [&](const std::type_info& candidate, detail::AnyKernel its_kernel) {
    if (law == candidate) kernel = its_kernel;
  };
  (try_law(typeid(Laws), reinterpret_cast<detail::AnyKernel>(&run<Laws>)), ...);
  return kernel;
}

}  // namespace

detail::AnyKernel any_block_kernel(const std::type_info& law) noexcept {
  return found(law, std::type_identity<AnyLaw>{});
}

}  // namespace scree::rheology::SCREE_INSTRUCTION_SET
