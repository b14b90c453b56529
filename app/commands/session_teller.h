#pragma once
// Says on stderr what changes in a running session: head or coil lost and why, found again, a camera that is
// away and back. One line each; what lasts less than a third of a second is not said.

#include <string>

#include "facenav/core/timestamp.h"
#include "facenav/treat/treatment.h"

namespace facenav::app {

class SessionTeller {
 public:
  explicit SessionTeller(bool is_quiet) : is_quiet_(is_quiet) {}
  void look(const steps::Treatment& treatment);

 private:
  bool is_quiet_;
  std::string told_, now_;  // of the newest state: what is wrong; empty: nothing is
  bool has_begun_ = false;
  Timestamp since_;  // it is so
};

}  // namespace facenav::app
