// Every law of the list over blocks of points; compiled once per instruction set, see
// cmake/scree_kernels.cmake.

#include "block_kernels.hpp"

#include "two_packs.hpp"

#include <scree/rheology/laws.hpp>
#include <scree/update_block.hpp>

#include <cstddef>
#include <experimental/simd>
#include <type_traits>
#include <variant>

namespace scree::rheology::SCREE_INSTRUCTION_SET {

namespace {

/// The points that are computed at once: a register of eight, two of four, or one point; `short_type` where a
/// law's chain of operations is short, one register.
template <std::size_t lanes>
struct NumberOf {
  using short_type = std::experimental::simd<double, std::experimental::simd_abi::deduce_t<double, lanes>>;
  using type = std::conditional_t<lanes == 4, TwoPacks<short_type>, short_type>;
};
template <>
struct NumberOf<1> {
  using short_type = double;
  using type = double;
};
using Number = NumberOf<num_lanes>::type;
/// Of a law in plane flow. A chain that is cut in two needs none beside it.
template <class Law>
using PlaneNumber =
    std::conditional_t<PredictsAndCorrects<Law>, typename NumberOf<num_lanes>::short_type, Number>;

/// Flattened: all that it calls is part of it, so that no copy for this instruction set is left for the
/// linker to choose elsewhere.
template <class Law>
[[gnu::flatten]] BlockStiffness run(const Law& law, const LawBlock<Law>& block, double dt) noexcept {
  return update_block<Number, Law, PlaneNumber<Law>>(law, block, dt);
}

template <class... Laws>
[[nodiscard, gnu::flatten]] detail::AnyKernel found(const std::type_info& law,
                                                    std::type_identity<std::variant<Laws...>> /*list*/) {
  detail::AnyKernel kernel = nullptr;
  const auto try_law = [&]<class Law>(std::type_identity<Law> /*candidate*/) {
    if constexpr (num_lanes <= most_lanes<Law>) {
      if (law == typeid(Law)) kernel = reinterpret_cast<detail::AnyKernel>(&run<Law>);
    }
  };
  (try_law(std::type_identity<Laws>{}), ...);
  return kernel;
}

}  // namespace

detail::AnyKernel any_block_kernel(const std::type_info& law) noexcept {
  return found(law, std::type_identity<AnyLaw>{});
}

}  // namespace scree::rheology::SCREE_INSTRUCTION_SET
