#pragma once

#include <scree/error.hpp>

#include <gtest/gtest.h>

#include <string>

namespace scree::mpm {

/// The message of the error of kind `Kind` that `call` throws; a test failure if it throws none.
template <class Kind, class Call>
[[nodiscard]] std::string message_of(Call&& call) {
  try {
    call();
  } catch (const Kind& error) {
    return error.what();
  }
  ADD_FAILURE() << "no error of the kind expected was thrown";
  return {};
}

}  // namespace scree::mpm
