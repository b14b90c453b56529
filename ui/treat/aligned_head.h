#pragma once
// AlignedHead: an alignment with what a person judges it by: the MRI's skin over the pictures that it was
// made from, and the check of the coil's tip.

#include <optional>

#include "facenav/align/alignment_seen.h"
#include "facenav/capture/recording.h"
#include "facenav/core/error.h"
#include "shell/services.h"

namespace facenav::ui {

struct AlignedHead {
  std::shared_ptr<const steps::AlignmentOutcome> outcome;  // null if not aligned
  /// Not aligned, because a person must confirm who the patient is (registration::PersonUnclear).
  std::optional<Error> person_unclear;
  steps::AlignmentSeen seen;                               // null members: nothing to show
  std::shared_ptr<const pictures::CameraOverlay> picture;  // null: none
};

/// Aligns the head; call it on a worker thread. Throws Error if it cannot be aligned.
AlignedHead alignHead(const Services& services, const casefile::CaseStore& store,
                      const capture::Recording& recording, const HeadKnown& known, TaskMonitor& monitor);

}  // namespace facenav::ui
