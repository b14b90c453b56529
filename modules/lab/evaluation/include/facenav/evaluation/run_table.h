#pragma once
// One row of values per run, for evaluation.csv and the report's table.

#include <string>
#include <utility>
#include <vector>

#include "facenav/evaluation/run_record.h"

namespace facenav::evaluation {

/// Values by name (with unit), always the same names in the same order. NaN if not measured.
std::vector<std::pair<std::string, double>> figuresOf(const RunRecord& run);

/// Formats a header and one line per run: scenario, head, rig, seed, failure, then the values (empty if not
/// measured).
std::string runsCsv(const std::vector<RunRecord>& runs);

}  // namespace facenav::evaluation
