#pragma once
// The report's tables of what was not as planned: pulses not on target or excluded, events, cautions.

#include <string>

#include "facenav/casefile/kept_session.h"
#include "facenav/report/session_review.h"

namespace facenav::report {

/// Each part: with its heading; empty if there is nothing to say.
std::string exceptionsPart(const casefile::KeptSession& session);
std::string eventsPart(const casefile::KeptSession& session);
std::string cautionsPart(const SessionSummary& summary);

}  // namespace facenav::report
