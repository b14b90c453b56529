#include "registrations.h"

namespace facenav::app {

Registrations makeRegistrations() {
  Registrations all;
  all.head_segmenters.add("head", "everything inside the skin", segmentation::makeHeadSegmenter);
  all.brain_segmenters.add("bet", "deformable surface", segmentation::makeBetSegmenter);
  all.aligners.add("surface", "robust point-to-plane on the skin's distance field",
                   registration::makeSurfaceAligner);
  all.aligners.add("icp", "the 2010 paper's iterative closest point", registration::makeIcpAligner);
  all.head_trackers.add("model", "skin patches fitted in both images at once",
                        tracking::makeModelHeadTracker);
  all.head_trackers.add("features7", "the 2010 paper's seven features", tracking::makeFeatureHeadTracker);
  all.coil_trackers.add("marker", "printed square markers", tracking::makeMarkerCoilTracker);
  return all;
}

}  // namespace facenav::app
