#pragma once

#include <string_view>
#include <vector>

namespace scree {

/// What hot loops are compiled for, each a superset of the one before; chosen once, when a run is assembled.
/// x86-64-v3 has fused multiply-adds and packs of four doubles (AVX2), x86-64-v4 packs of eight (AVX-512).
enum class InstructionSet { baseline, x86_64_v3, x86_64_v4 };

/// As compilers call it: "baseline", "x86-64-v3", "x86-64-v4".
[[nodiscard]] std::string_view name_of(InstructionSet set) noexcept;

/// Those that this build has kernels for and this machine can run, narrowest first; never empty.
[[nodiscard]] std::vector<InstructionSet> instruction_sets();

/// The widest of them. Results of two sets differ in their last bits: sums are contracted differently.
[[nodiscard]] InstructionSet widest_instruction_set() noexcept;

}  // namespace scree
