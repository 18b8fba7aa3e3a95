#include "arkode_handles.hpp"

#include <scree/error.hpp>

#include <cstdlib>

namespace scree::transport::detail {

void check(int flag, const char* call, const std::string& said) {
  if (flag >= 0) return;
  const std::unique_ptr<char, decltype(&std::free)> word{ARKStepGetReturnFlagName(flag), &std::free};
  std::string text = std::string{"ImexIntegrator: "} + call + " failed with " + word.get();
  if (!said.empty()) text += ": " + said;
  throw RunError{text};
}

Context make_context() {
  SUNContext context = nullptr;
  check(SUNContext_Create(nullptr, &context), "SUNContext_Create");
  return Context{context};
}

}  // namespace scree::transport::detail
