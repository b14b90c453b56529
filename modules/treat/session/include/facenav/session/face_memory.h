#pragma once
// Converts key frames of the patient's face between sessions. The case stores them relative to the MRI
// (casefile/face_looks.h); the tracker needs them relative to this session's head
// (head_tracking/face_key_frame.h).

#include <vector>

#include "facenav/casefile/face_looks.h"
#include "facenav/head_tracking/face_key_frame.h"

namespace facenav::session {

/// Converts stored key frames for the tracker. `head_T_mri`: this session's alignment; Head = Camera at the
/// reference. Both sessions' alignments have errors of some tenths of a millimetre, so each key frame also
/// gets that error (between_sessions).
std::vector<head_tracking::FaceKeyFrame> asTracked(const std::vector<casefile::StoredKeyFrame>& key_frames,
                                                   const RigidTransform<Head, Mri>& head_T_mri);
std::vector<casefile::StoredKeyFrame> asKept(const std::vector<head_tracking::FaceKeyFrame>& key_frames,
                                             const RigidTransform<Head, Mri>& head_T_mri);

}  // namespace facenav::session
