#pragma once
// Lists the targets of a session's pulses, as they were then.

#include <string>

#include "facenav/casefile/case_store.h"
#include "facenav/casefile/kept_session.h"

namespace facenav::report {

std::string targetsPart(const casefile::CaseStore& store, const casefile::KeptSession& session);

}  // namespace facenav::report
