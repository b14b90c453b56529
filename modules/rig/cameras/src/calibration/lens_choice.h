#pragma once
// Chooses the lens model by cross-validation. A fuller model always lowers the error of the views that it was
// fitted to; only views left out show whether it is better.

#include "board_views.h"
#include "facenav/core/task_monitor.h"
#include "rig_adjustment.h"

namespace facenav::cameras {

struct LensModel {
  const char* name;
  LensTerms terms;
};

struct LensChoice {
  LensModel taken;
  double held_out_rms_px = 0;
  std::vector<ModelReport> tried;
};

/// Two radial and two tangential terms: fits most lenses; the first model tried.
const LensModel& usualLens();

RigFit solve(const BoardViews& task, const ViewIndices& used, const LensModel& model);

/// Chooses a model. Throws Error or cv::Exception if the views do not determine the cameras.
LensChoice chooseLens(const BoardViews& task, const ViewIndices& used, TaskMonitor& monitor);

}  // namespace facenav::cameras
