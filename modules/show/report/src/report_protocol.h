#pragma once
// The protocol against what was given: pulses, trains, frequency, pauses and intensity. The plan is the one
// that the session kept when it began (protocol.json in its folder), else the case's of today.

#include <string>

#include "facenav/casefile/case_store.h"
#include "facenav/casefile/kept_session.h"

namespace facenav::report {

/// "10 trains, 20.0 pulses each on average, 10.0 Hz, pauses of 25.0 s (medians)".
std::string trainWords(const casefile::CaseStore& store, const casefile::KeptSession& session);
/// A table and its words; empty without a protocol. Damaged: that is said.
std::string protocolPart(const casefile::CaseStore& store, const casefile::KeptSession& session);

}  // namespace facenav::report
