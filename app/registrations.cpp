#include "registrations.h"

namespace facenav::app {

namespace {

std::function<std::shared_ptr<const face::FaceDetector>()> madeOnce() {
  // The state is shared, so that copies of the function return the same detector.
  return [made = std::make_shared<std::shared_ptr<const face::FaceDetector>>()] {
    if (!*made) *made = face::makeFaceDetector();
    return *made;
  };
}

void addExporters(Registry<casefile::Exporter>& exporters) {
  using surface::MeshFormat;
  const auto mesh = [](MeshFormat format) { return [format] { return casefile::makeMeshExporter(format); }; };
  exporters.add("stl", "scalp, brain and cortex for printing and CAD", mesh(MeshFormat::stl));
  exporters.add("ply", "scalp, brain and cortex with normals", mesh(MeshFormat::ply));
  exporters.add("obj", "scalp, brain and cortex for modelling programs", mesh(MeshFormat::obj));
  exporters.add("vtp", "scalp, brain and cortex for VTK and ParaView", mesh(MeshFormat::vtp));
  exporters.add("gifti", "scalp, brain and cortex for neuroimaging programs", mesh(MeshFormat::gifti));
  exporters.add("nifti", "MRI and masks", casefile::makeNiftiExporter);
}

}  // namespace

steps::Registrations makeRegistrations() {
  steps::Registrations all;
  all.face_detector = madeOnce();
  all.head_segmenters.add("head", "everything inside the skin", segmentation::makeHeadSegmenter);
  all.brain_segmenters.add("brain", "tissue classes on a deformable surface",
                           segmentation::makeBrainSegmenter);
  all.brain_segmenters.add("prior", "learned outline fitted to the scan, any contrast",
                           segmentation::makePriorSegmenter);
  all.aligners.add("surface", "robust point-to-plane on the skin's distance field",
                   registration::makeSurfaceAligner);
  all.head_trackers.add("model", "skin patches fitted in both images at once",
                        [face = all.face_detector] { return head_tracking::makeModelHeadTracker(face()); });
  all.coil_trackers.add("marker", "printed square markers", coil_tracking::makeMarkerCoilTracker);
  addExporters(all.exporters);
  all.cameras.add("v4l2", "USB and other Video4Linux cameras", [] { return capture::makeV4l2Backend(); });
  all.cameras.add("genicam", "GigE Vision and USB3 Vision cameras", capture::makeGenicamBackend);
  all.cameras.add("dc1394", "IEEE 1394 (FireWire) cameras", [] { return capture::makeDc1394Backend(); });
  all.cameras.add("stream", "network streams and videos", capture::makeStreamBackend);
  return all;
}

}  // namespace facenav::app
