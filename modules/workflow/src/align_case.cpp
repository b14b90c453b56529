#include "facenav/workflow/align_case.h"

#include "facenav/casefile/skin_fit_file.h"
#include "facenav/core/error.h"
#include "facenav/pictures/skin_fit_picture.h"
#include "facenav/workflow/case_pictures.h"
#include "facenav/workflow/stored_capture.h"

namespace facenav::workflow {

AlignmentOutcome alignCase(const Registrations& methods, const casefile::CaseStore& store,
                           const stereo::StereoRig& rig, const capture::CapturePair& capture,
                           const std::string& aligner, TaskMonitor& monitor) {
  const auto detector = methods.face_detector();
  auto outcome = alignFromCapture(rig, capture, store.scalp(), *methods.aligners.create(aligner), *detector,
                                  store.targets().targets, monitor, store.scalpField());
  writeStoredCapture(store.folder(), rig, capture);
  casefile::writeSkinFit(outcome.result, outcome.face.cloud, store.folder() / "skin_fit.vtp");
  writePrivatePng(pictures::drawSkinFit(capture.plain.left, outcome.face, outcome.result),
                  store.folder() / "skin_fit.png");
  store.setAlignment(outcome.stored());
  return outcome;
}

capture::CapturePair captureOf(const casefile::CaseStore& store, const capture::Recording& recording) {
  if (recording.capture) return *recording.capture;
  if (auto stored = readStoredCapture(store.folder(), recording.rig)) return *stored;
  throw Error("not aligned: the recording has no capture pair", recording.folder.string(),
              "record one with the dots projected (capture/ in the recording)");
}

}  // namespace facenav::workflow
