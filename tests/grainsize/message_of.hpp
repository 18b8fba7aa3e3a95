#pragma once

#include <scree/error.hpp>

#include <gtest/gtest.h>

#include <string>

namespace scree::test {

/// The message of the InputError that `call` throws; a test failure if it throws none.
template <class Call>
[[nodiscard]] std::string message_of(Call&& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  ADD_FAILURE() << "no InputError was thrown";
  return {};
}

}  // namespace scree::test
