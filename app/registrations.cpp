#include "registrations.h"

namespace facenav::app {

namespace {

std::function<std::shared_ptr<const tracking::FaceDetector>()> madeOnce() {
  // The state is shared, so that copies of the function return the same detector.
  return [made = std::make_shared<std::shared_ptr<const tracking::FaceDetector>>()] {
    if (!*made) *made = tracking::makeFaceDetector();
    return *made;
  };
}

}  // namespace

Registrations makeRegistrations() {
  Registrations all;
  all.face_detector = madeOnce();
  all.head_segmenters.add("head", "everything inside the skin", segmentation::makeHeadSegmenter);
  all.brain_segmenters.add("brain", "tissue classes on a deformable surface",
                           segmentation::makeBrainSegmenter);
  all.brain_segmenters.add("bet", "plain deformable surface", segmentation::makeBetSegmenter);
  all.aligners.add("surface", "robust point-to-plane on the skin's distance field",
                   registration::makeSurfaceAligner);
  all.aligners.add("icp", "the 2010 paper's iterative closest point", registration::makeIcpAligner);
  all.head_trackers.add("model", "skin patches fitted in both images at once",
                        [face = all.face_detector] { return tracking::makeModelHeadTracker(face()); });
  all.head_trackers.add("features7", "the 2010 paper's seven features",
                        [face = all.face_detector] { return tracking::makeFeatureHeadTracker(face()); });
  all.coil_trackers.add("marker", "printed square markers", tracking::makeMarkerCoilTracker);
  return all;
}

}  // namespace facenav::app
