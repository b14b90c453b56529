#pragma once
// Reports changes of a running session on stderr, one line each: head or coil lost and why, found again, a
// camera away and back. A change shorter than a third of a second is not reported.

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
  std::string told_, now_;  // fault last reported, and fault of the newest state; empty if none
  bool has_begun_ = false;
  Timestamp since_;  // start of the present fault or its absence
};

}  // namespace facenav::app
