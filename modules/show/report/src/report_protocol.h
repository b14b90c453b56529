#pragma once
// Compares the protocol with what was given: pulses, trains, frequency, pauses and intensity. The plan is the
// one stored with the session at its begin (protocol.json in its folder), else the case's current one.

#include <string>

#include "facenav/casefile/case_store.h"
#include "facenav/casefile/kept_session.h"

namespace facenav::report {

/// Returns "10 trains, 20.0 pulses each on average, 10.0 Hz, pauses of 25.0 s (medians)".
std::string trainWords(const casefile::CaseStore& store, const casefile::KeptSession& session);
/// Returns a table and its words; empty without a protocol. A damaged protocol is reported.
std::string protocolPart(const casefile::CaseStore& store, const casefile::KeptSession& session);

}  // namespace facenav::report
