#pragma once
// The demo's report: figures, table "this run | the paper", written into the result folder.

#include <filesystem>
#include <string>
#include <vector>

#include "facenav/casefile/case_store.h"
#include "facenav/evaluation/html_report.h"
#include "facenav/evaluation/tracking_evaluation.h"

namespace facenav::app {

/// The demo's results, measured against the truth of the virtual room.
struct DemoFigures {
  casefile::StoredAlignment alignment;
  double alignment_rotation_deg = 0, alignment_at_target_mm = 0;
  evaluation::TrackingEvaluation protractor;    // head, at the cortical target
  evaluation::TrackingEvaluation head, coil;    // the treatment; coil at the centre of its contact face
  evaluation::ErrorStatistics coil_on_head_mm;  // coil centre in Mri against its truth, treatment
  double final_distance_mm = 0;                 // true distance from coil to target at the end
  int frames_on_target = 0;
  std::vector<std::pair<std::string, double>> step_s;  // duration of each step
  double total_s = 0;
};

/// Writes the error over the rotation angle (paper, figure 13), one curve per axis, as SVG. `truth` gives the
/// angles.
void writeProtractorPlot(const evaluation::TrackingEvaluation& protractor,
                         const std::map<std::int64_t, Eigen::Isometry3d>& truth,
                         const std::filesystem::path& svg);

/// Writes report.html in `folder`; `pictures` are files in it with their captions.
void writeDemoReport(const DemoFigures& figures, const std::vector<evaluation::ReportFigure>& pictures,
                     const std::filesystem::path& folder);

/// Formats the results in a few lines for the terminal.
std::string summary(const DemoFigures& figures);

}  // namespace facenav::app
