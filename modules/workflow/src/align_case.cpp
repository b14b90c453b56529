#include "facenav/workflow/align_case.h"

#include "facenav/casefile/file_group.h"
#include "facenav/casefile/skin_fit_file.h"
#include "facenav/core/error.h"
#include "facenav/pictures/skin_fit_picture.h"
#include "facenav/workflow/case_pictures.h"
#include "facenav/workflow/stored_capture.h"

namespace facenav::workflow {

void storeAlignment(const casefile::CaseStore& store, const cameras::StereoRig& rig,
                    const capture::CapturePair& capture, const AlignmentOutcome& outcome) {
  casefile::FileGroup group(store.folder());
  writeStoredCapture(group, rig, capture);
  casefile::writeSkinFit(outcome.result, outcome.face.cloud, group.staging() / "skin_fit.vtp");
  writePrivatePng(pictures::drawSkinFit(capture.plain.left, outcome.face, outcome.result),
                  group.staging() / "skin_fit.png");
  casefile::writeAlignment(outcome.stored(), group.staging() / "alignment.json");
  group.commit("alignment.json");
}

AlignmentOutcome alignCase(const Registrations& methods, const casefile::CaseStore& store,
                           const cameras::StereoRig& rig, const capture::CapturePair& capture,
                           const std::string& aligner, TaskMonitor& monitor, const std::string& matcher) {
  const auto detector = methods.face_detector();
  auto outcome = alignFromCapture(rig, capture, store.scalp(), *methods.aligners.create(aligner), *detector,
                                  store.targets().targets, monitor, store.scalpField(), matcher);
  storeAlignment(store, rig, capture, outcome);
  return outcome;
}

capture::CapturePair captureOf(const casefile::CaseStore& store, const capture::Recording& recording) {
  if (recording.capture) return *recording.capture;
  if (auto stored = readStoredCapture(store.folder(), recording.rig)) return *stored;
  throw Error("not aligned: the recording has no capture pair", recording.folder.string(),
              "record one with the dots projected (capture/ in the recording)");
}

}  // namespace facenav::workflow
