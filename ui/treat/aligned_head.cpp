#include "treat/aligned_head.h"

namespace facenav::ui {

AlignedHead alignHead(const Services& services, const casefile::CaseStore& store,
                      const capture::Recording& recording, const coil_tracking::CoilModel& coil,
                      TaskMonitor& monitor) {
  AlignedHead aligned;
  aligned.outcome =
      std::make_shared<const steps::AlignmentOutcome>(services.align(store, recording, &coil, monitor));
  if (!services.seeAlignment) return aligned;
  aligned.seen = services.seeAlignment(store, *aligned.outcome);
  aligned.picture = std::make_shared<const pictures::CameraOverlay>(
      steps::drawAlignment(recording.rig, *aligned.outcome, aligned.seen));
  return aligned;
}

}  // namespace facenav::ui
