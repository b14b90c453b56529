#pragma once
// Tables of `facenav evaluate gates`: one CSV line a trial, and the summary by fault, even and odd seeds
// apart.

#include <string>
#include <vector>

#include "evaluate/gate_trial.h"

namespace facenav::app {

/// First line of the CSV.
std::string gateHeader();
/// Line of a trial.
std::string gateLine(const GateRow& row);
/// Markdown: accepted, tracked, found again, wrong poses, faults named, errors; then the reasons of refusals
/// and losses without a fault.
std::string gateSummary(const std::vector<GateRow>& rows);

}  // namespace facenav::app
