#pragma once
// WrongUsage: options that do not go together, or a typed value that says nothing. The program ends with exit
// status 2 and names the verb's help, as for options that CLI11 itself refuses.

#include "facenav/core/error.h"

namespace facenav::app {

class WrongUsage : public Error {
 public:
  explicit WrongUsage(const std::string& what_is_wrong, const std::string& remedy = {})
      : Error(what_is_wrong, {}, remedy) {}
};

/// Runs `read`, which reads what was typed; an Error of it is wrong usage.
template <class Read>
void requireUnderstood(Read read) {
  try {
    read();
  } catch (const Error& error) {
    throw WrongUsage(error.what());
  }
}

}  // namespace facenav::app
