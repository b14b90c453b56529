#pragma once
// The targets that a session's pulses were given at, as they were then.

#include <string>

#include "facenav/casefile/case_store.h"
#include "facenav/casefile/kept_session.h"

namespace facenav::report {

std::string targetsPart(const casefile::CaseStore& store, const casefile::KeptSession& session);

}  // namespace facenav::report
