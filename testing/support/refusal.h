#pragma once
// The words that an action is refused with.

#include <functional>
#include <string>

#include "facenav/core/error.h"

namespace facenav::testing {

/// What() of the Error that `act` throws; empty: it threw none.
inline std::string refusalOf(const std::function<void()>& act) {
  try {
    act();
    return "";
  } catch (const Error& error) {
    return error.what();
  }
}

}  // namespace facenav::testing
