#pragma once

// What the libraries that call SUNDIALS share: owned handles, and flags that are checked. Sources include it,
// public headers do not, and it is not installed.

#include <scree/error.hpp>

#include <sundials/sundials_context.h>
#include <sundials/sundials_linearsolver.h>
#include <sundials/sundials_matrix.h>
#include <sundials/sundials_nvector.h>

#include <cstdlib>
#include <exception>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <utility>

namespace scree::sundials {

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

/// The values of a serial vector.
[[nodiscard]] inline std::span<double> values(N_Vector vector) noexcept {
  return {N_VGetArrayPointer(vector), static_cast<std::size_t>(N_VGetLength(vector))};
}

/// A solver's own word for a flag; the caller frees it.
using FlagName = char* (*)(long);

/// @throws RunError naming who called what, the solver's own word for the flag and what it `said`, if `flag`
/// is negative.
inline void check(int flag, FlagName word_for, const char* who, const char* call,
                  const std::string& said = {}) {
  if (flag >= 0) return;
  const std::unique_ptr<char, decltype(&std::free)> word{word_for(flag), &std::free};
  std::string text = std::string{who} + ": " + call + " failed with " + word.get();
  if (!said.empty()) text += ": " + said;
  throw RunError{text};
}

/// @throws RunError naming who called what, if `made` is null.
template <class Handle>
[[nodiscard]] Handle require_made(Handle made, const char* who, const char* call) {
  if (!made) throw RunError{std::string{who} + ": " + call + " made nothing: out of memory"};
  return made;
}

/// One for each solver, and so one for each thread. @throws RunError if there is no memory for it.
[[nodiscard]] inline Context make_context(const char* who) {
  SUNContext context = nullptr;
  if (SUNContext_Create(nullptr, &context) != 0) context = nullptr;
  return require_made(Context{context}, who, "SUNContext_Create");
}

/// Lets no exception through C: it is kept, the call fails, and `rethrow` throws it on the other side.
class Guard {
 public:
  void start() noexcept { thrown_ = nullptr; }
  /// Throws what a body has thrown, if one has.
  void rethrow() {
    if (thrown_) std::rethrow_exception(std::exchange(thrown_, nullptr));
  }
  /// @return 0, or -1 if the body threw: SUNDIALS' sign for "do not try again"
  template <class Body>
  int run(Body&& body) noexcept {
    try {
      body();
      return 0;
    } catch (...) {
      thrown_ = std::current_exception();
      return -1;
    }
  }

 private:
  std::exception_ptr thrown_;
};

}  // namespace scree::sundials
