#pragma once
// The demo's pictures and video: navigation displays of chosen frames (paper, figures 4, 6, 8, 9) and
// cross-sections of the alignment (figure 11). Needs an X display; a virtual one is enough.

#include <filesystem>
#include <memory>
#include <vector>

#include "facenav/align/align_from_capture.h"
#include "facenav/casefile/case_store.h"
#include "facenav/core/task_monitor.h"
#include "facenav/evaluation/html_report.h"
#include "facenav/session/navigation_state.h"

namespace facenav::app {

struct PictureInput {
  const casefile::CaseStore& store;
  const cameras::StereoRig& rig;
  guidance::Target target;
  std::vector<std::shared_ptr<const session::NavigationState>> states;  // of the treatment, in order
};

/// Writes PNGs of the brain and of states spread over the treatment, and a video of all states, with captions
/// for the report.
std::vector<evaluation::ReportFigure> drawNavigation(const PictureInput& input,
                                                     const std::filesystem::path& folder,
                                                     TaskMonitor& monitor);

/// Draws three cross-sections of the MRI through the face with the face cloud in red.
std::vector<evaluation::ReportFigure> drawAlignment(const casefile::CaseStore& store,
                                                    const steps::AlignmentOutcome& outcome,
                                                    const std::filesystem::path& folder);

}  // namespace facenav::app
