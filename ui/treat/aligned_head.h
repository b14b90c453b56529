#pragma once
// AlignedHead: an alignment with what a person judges it by: the MRI's skin over the pictures that it was
// made from, and the check of the coil's tip.

#include "facenav/align/alignment_seen.h"
#include "facenav/capture/recording.h"
#include "shell/services.h"

namespace facenav::ui {

struct AlignedHead {
  std::shared_ptr<const steps::AlignmentOutcome> outcome;  // null if not aligned
  steps::AlignmentSeen seen;                               // null members: nothing to show
  std::shared_ptr<const pictures::CameraOverlay> picture;  // null: none
};

/// Aligns the head; call it on a worker thread. Throws Error if it cannot be aligned.
AlignedHead alignHead(const Services& services, const casefile::CaseStore& store,
                      const capture::Recording& recording, const coil_tracking::CoilModel& coil,
                      TaskMonitor& monitor);

}  // namespace facenav::ui
