#pragma once

#include <scree/transport_stiff/imex_problem.hpp>

#include <arkode/arkode_arkstep.h>
#include <sundials/sundials_context.h>
#include <sundials/sundials_linearsolver.h>
#include <sundials/sundials_matrix.h>
#include <sundials/sundials_nvector.h>

#include <memory>
#include <string>
#include <type_traits>

namespace scree::transport::detail {

struct FreeContext {
  void operator()(SUNContext context) const noexcept { SUNContext_Free(&context); }
};
using Context = std::unique_ptr<std::remove_pointer_t<SUNContext>, FreeContext>;

struct FreeVector {
  void operator()(N_Vector vector) const noexcept { N_VDestroy(vector); }
};
using SerialVector = std::unique_ptr<std::remove_pointer_t<N_Vector>, FreeVector>;

struct FreeMatrix {
  void operator()(SUNMatrix matrix) const noexcept { SUNMatDestroy(matrix); }
};
using SystemMatrix = std::unique_ptr<std::remove_pointer_t<SUNMatrix>, FreeMatrix>;

struct FreeLinearSolver {
  void operator()(SUNLinearSolver solver) const noexcept { SUNLinSolFree(solver); }
};
using LinearSolver = std::unique_ptr<std::remove_pointer_t<SUNLinearSolver>, FreeLinearSolver>;

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
void check(int flag, const char* call, const std::string& said = {});

/// @throws RunError naming the call if `made` is null.
template <class Handle>
Handle require_made(Handle made, const char* call) {
  if (!made) check(ARK_MEM_FAIL, call);
  return made;
}

[[nodiscard]] Context make_context();

/// The tables of a method.  Eqs. (T51) - (T53)
struct TablePair {
  Table implicit_half;
  Table explicit_half;
};
[[nodiscard]] TablePair make_tables(ImexMethod method);

}  // namespace scree::transport::detail
