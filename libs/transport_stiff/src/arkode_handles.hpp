#pragma once

#include <scree/transport_stiff/imex_problem.hpp>

#include <arkode/arkode_arkstep.h>
#include <sundials_handles.hpp>

#include <memory>
#include <string>
#include <type_traits>
#include <utility>

namespace scree::transport::detail {

using sundials::Context;
using sundials::LinearSolver;
using sundials::SerialVector;
using sundials::SystemMatrix;
using sundials::values;

struct FreeTable {
  void operator()(ARKodeButcherTable table) const noexcept { ARKodeButcherTable_Free(table); }
};
using Table = std::unique_ptr<std::remove_pointer_t<ARKodeButcherTable>, FreeTable>;

struct FreeArkode {
  void operator()(void* memory) const noexcept { ARKStepFree(&memory); }
};
using ArkodeMemory = std::unique_ptr<void, FreeArkode>;

/// @throws RunError naming the call, ARKODE's own word for the flag and what it `said`, if `flag` is
/// negative.
inline void check(int flag, const char* call, const std::string& said = {}) {
  sundials::check(flag, &ARKStepGetReturnFlagName, "ImexIntegrator", call, said);
}

/// @throws RunError naming the call if `made` is null.
template <class Handle>
[[nodiscard]] Handle require_made(Handle made, const char* call) {
  return sundials::require_made(std::move(made), "ImexIntegrator", call);
}

/// The tables of a method.  Eqs. (T51) - (T53)
struct TablePair {
  Table implicit_half;
  Table explicit_half;
};
[[nodiscard]] TablePair make_tables(ImexMethod method);

}  // namespace scree::transport::detail
