#pragma once
// The capture pair an alignment rests on, kept in the case (alignment_capture/), so that a later recording
// without a capture of its own can be tracked against the face as it was when the alignment was made.

#include <filesystem>
#include <optional>

#include "facenav/capture/recording.h"
#include "facenav/casefile/file_group.h"

namespace facenav::workflow {

/// Into a group of the case's files: photographs of the patient's face, private from the first byte.
void writeStoredCapture(const casefile::FileGroup& group, const cameras::StereoRig& rig,
                        const capture::CapturePair& pair);
/// Nothing where there is none. Throws Error where it was taken with another rig than `rig`: the alignment
/// then says nothing about these cameras.
std::optional<capture::CapturePair> readStoredCapture(const std::filesystem::path& case_folder,
                                                      const cameras::StereoRig& rig);

}  // namespace facenav::workflow
