#include "treat/aligned_head.h"

namespace facenav::ui {

AlignedHead alignHead(const Services& services, const casefile::CaseStore& store,
                      const capture::Recording& recording, const HeadKnown& known, TaskMonitor& monitor) {
  AlignedHead aligned;
  try {
    aligned.outcome =
        std::make_shared<const steps::AlignmentOutcome>(services.align(store, recording, known, monitor));
  } catch (const registration::PersonUnclear& error) {
    aligned.person_unclear = error;
    return aligned;
  }
  if (!services.seeAlignment) return aligned;
  aligned.seen = services.seeAlignment(store, *aligned.outcome);
  aligned.picture = std::make_shared<const pictures::CameraOverlay>(
      steps::drawAlignment(recording.rig, *aligned.outcome, aligned.seen));
  return aligned;
}

}  // namespace facenav::ui
