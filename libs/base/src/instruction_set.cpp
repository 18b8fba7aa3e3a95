#include <scree/instruction_set.hpp>

namespace scree {

namespace {

/// The features that tell machines of each level apart; whoever has them has the rest of the level.
[[nodiscard]] bool runs_here(InstructionSet set) noexcept {
#ifdef SCREE_WIDE_KERNELS
  const bool v3 = __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0 &&
                  __builtin_cpu_supports("bmi2") != 0;
  const bool v4 = v3 && __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512bw") != 0 &&
                  __builtin_cpu_supports("avx512cd") != 0 && __builtin_cpu_supports("avx512dq") != 0 &&
                  __builtin_cpu_supports("avx512vl") != 0;
#else
  const bool v3 = false;
  const bool v4 = false;
#endif
  switch (set) {
    case InstructionSet::x86_64_v3:
      return v3;
    case InstructionSet::x86_64_v4:
      return v4;
    default:
      return true;
  }
}

}  // namespace

std::string_view name_of(InstructionSet set) noexcept {
  switch (set) {
    case InstructionSet::x86_64_v3:
      return "x86-64-v3";
    case InstructionSet::x86_64_v4:
      return "x86-64-v4";
    default:
      return "baseline";
  }
}

std::vector<InstructionSet> instruction_sets() {
  std::vector<InstructionSet> sets;
  for (const auto set : {InstructionSet::baseline, InstructionSet::x86_64_v3, InstructionSet::x86_64_v4}) {
    if (runs_here(set)) sets.push_back(set);
  }
  return sets;
}

InstructionSet widest_instruction_set() noexcept {
  if (runs_here(InstructionSet::x86_64_v4)) return InstructionSet::x86_64_v4;
  return runs_here(InstructionSet::x86_64_v3) ? InstructionSet::x86_64_v3 : InstructionSet::baseline;
}

}  // namespace scree
