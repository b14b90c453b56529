#pragma once
// ALIGN: the third step of the data flow, used by the verb, the window and the demo. The capture pair and the
// case's scalp -> alignment.json and the files that go with it, in the case.

#include <string>

#include "facenav/capture/recording.h"
#include "facenav/casefile/case_store.h"
#include "facenav/workflow/align_from_capture.h"
#include "facenav/workflow/registrations.h"

namespace facenav::workflow {

/// Aligns by the method registered as `aligner`, on the face as `matcher` measures it. Writes alignment.json,
/// the map of the skin's fit and the capture pair into the case. Throws Error ("not aligned: ..").
AlignmentOutcome alignCase(const Registrations& methods, const casefile::CaseStore& store,
                           const cameras::StereoRig& rig, const capture::CapturePair& capture,
                           const std::string& aligner, TaskMonitor& monitor,
                           const std::string& matcher = stereo::kDefaultMatcher);

/// Writes an alignment and its files into the case: alignment.json, alignment_capture/ (photographs),
/// skin_fit.vtp and skin_fit.png. All or none, private to the user from the first byte. Throws Error; the
/// previous alignment is then unchanged.
void storeAlignment(const casefile::CaseStore& store, const cameras::StereoRig& rig,
                    const capture::CapturePair& capture, const AlignmentOutcome& outcome);

/// The recording's own capture pair, or else the one that the case was aligned with. Throws Error if there is
/// none, or if the case's pair was taken with another rig.
capture::CapturePair captureOf(const casefile::CaseStore& store, const capture::Recording& recording);

}  // namespace facenav::workflow
