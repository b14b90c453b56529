#pragma once
// Everything to replay a session: its track (poses and guidance over time), its targets as they were then,
// its pulses, and the pictures of its recording if they still exist.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "facenav/capture/recording_pictures.h"
#include "facenav/casefile/session_pulses.h"
#include "facenav/casefile/session_track.h"

namespace facenav::steps {

struct SessionReplay {
  casefile::SessionTrack track;
  std::shared_ptr<capture::RecordingPictures> pictures;  // null: none
  std::string pictures_words;                            // why there are none; empty if there are
};

/// Opens poses.csv and guidance.csv in `folder` (a session, or any folder with the output of track and
/// guide). The pictures are those of a recording in the folder (itself or recording/), else those of the
/// pulses' frames (evidence/). Throws Error without poses.
SessionReplay openReplay(const std::filesystem::path& folder);
/// Opens the pictures of another recording folder. Throws Error if they do not belong to this track: its
/// frames must have the numbers and, within 1 ms, the times of the track's.
std::shared_ptr<capture::RecordingPictures> openPictures(const std::filesystem::path& recording,
                                                         const casefile::SessionTrack& track);

/// Returns "face lost: no_face", "coil lost: no_marker", "not aligned with the MRI"; empty if both have
/// poses.
std::string lossAt(const casefile::SessionTrack& track, const casefile::TrackMoment& moment);

}  // namespace facenav::steps
