#pragma once
// The evaluation's plots, as SVG files with their captions.

#include <filesystem>
#include <vector>

#include "facenav/evaluation/html_report.h"
#include "facenav/evaluation/run_record.h"

namespace facenav::evaluation {

/// Writes only the plots for which the runs have data.
std::vector<ReportFigure> writePlots(const std::vector<RunRecord>& runs, const std::filesystem::path& folder);

}  // namespace facenav::evaluation
