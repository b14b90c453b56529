#pragma once
// The electric field at a session's pulses: at the target, its maximum, and by which model of the head.

#include <string>

#include "facenav/casefile/kept_session.h"

namespace facenav::report {

std::string fieldPart(const casefile::KeptSession& session);

}  // namespace facenav::report
