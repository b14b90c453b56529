#pragma once
// The evaluation's folder: report.html with goals, runs and plots, evaluation.md (the goals as a Markdown
// table), evaluation.csv (one row per run) and the plots as SVG.

#include <filesystem>
#include <string>
#include <vector>

#include "facenav/evaluation/run_record.h"

namespace facenav::evaluation {

/// "| quantity | goal | measured | | over |" with one row per goal, then the runs that failed.
std::string goalsMarkdown(const std::vector<RunRecord>& runs);

/// Writes all files into `folder`, which must exist. `about`: one or two lines on what was run.
void writeEvaluation(const std::vector<RunRecord>& runs, const std::string& about,
                     const std::filesystem::path& folder);

}  // namespace facenav::evaluation
