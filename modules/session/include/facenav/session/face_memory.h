#pragma once
// The looks of the patient's face between sessions: the case keeps them against the MRI
// (casefile/face_looks.h), the tracker wants them against the head of this session (tracking/face_look.h).

#include <vector>

#include "facenav/casefile/face_looks.h"
#include "facenav/head_tracking/face_look.h"

namespace facenav::session {

/// `head_T_mri`: this session's alignment; Head = Camera at the reference. Both alignments err by some tenths
/// of a millimetre: that is stated with the poses.
std::vector<head_tracking::FaceLook> asTracked(const std::vector<casefile::KeptLook>& looks,
                                               const RigidTransform<Head, Mri>& head_T_mri);
std::vector<casefile::KeptLook> asKept(const std::vector<head_tracking::FaceLook>& looks,
                                       const RigidTransform<Head, Mri>& head_T_mri);

}  // namespace facenav::session
