#pragma once
// The message of a refused action.

#include <functional>
#include <string>

#include "facenav/core/error.h"

namespace facenav::testing {

/// Returns what() of the Error that `act` throws; empty if it threw none.
inline std::string refusalOf(const std::function<void()>& act) {
  try {
    act();
    return "";
  } catch (const Error& error) {
    return error.what();
  }
}

}  // namespace facenav::testing
