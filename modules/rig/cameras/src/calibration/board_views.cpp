#include "board_views.h"

#include <algorithm>
#include <cmath>

namespace facenav::cameras {

std::vector<ViewFit> fitViews(const BoardViews& task, const StereoRig& rig, const ViewIndices& indices) {
  std::vector<ViewFit> fits;
  for (const std::size_t i : indices) fits.push_back(fitBoard(rig, task.views[i], task.board));
  return fits;
}

double rmsOf(const std::vector<ViewFit>& fits) {
  double squares = 0;
  for (const auto& fit : fits) squares += fit.rms_px() * fit.rms_px();
  return std::sqrt(squares / double(std::max<std::size_t>(1, fits.size())));
}

}  // namespace facenav::cameras
