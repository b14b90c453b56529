#include "facenav/review/session_replay.h"

#include <algorithm>
#include <cmath>

#include "facenav/casefile/evidence.h"
#include "facenav/casefile/session_so_far.h"
#include "facenav/core/error.h"
#include "facenav/core/number_text.h"

namespace facenav::steps {
namespace fs = std::filesystem;
namespace {

constexpr double kSameTime_s = 1e-3;

/// Throws Error unless the frames agree. A live session's times have another zero than those of its
/// recording, so only time steps are compared then.
void requireSameFrames(const casefile::SessionTrack& track, const capture::RecordingPictures& pictures,
                       const fs::path& recording) {
  const auto& numbers = pictures.numbers();
  std::size_t shared = 0;
  std::optional<double> offset_s;
  for (const auto& moment : track.moments) {
    const auto found = std::lower_bound(numbers.begin(), numbers.end(), moment.frame);
    if (found == numbers.end() || *found != moment.frame) continue;
    ++shared;
    const double ahead_s = pictures.times_s()[std::size_t(found - numbers.begin())] - moment.t_s;
    if (!offset_s) offset_s = ahead_s;
    if (std::abs(ahead_s - *offset_s) > kSameTime_s)
      throw Error(formatted("frame %ld is of another moment than the session's", long(moment.frame)),
                  recording.string(), "choose the recording of this session");
  }
  if (shared == 0)
    throw Error("no frame of the session is in this recording", recording.string(),
                "choose the recording of this session");
}

/// Repairs the evidence of a session that does not run: a crash may have cut a pulse's pictures short.
void mendUnlessRunning(const fs::path& session_folder) {
  if (!casefile::sessionSoFar(session_folder).is_running) casefile::mendEvidence(session_folder);
}

}  // namespace

std::shared_ptr<capture::RecordingPictures> openPictures(const fs::path& recording,
                                                         const casefile::SessionTrack& track) {
  auto pictures = std::make_shared<capture::RecordingPictures>(recording);
  requireSameFrames(track, *pictures, recording);
  return pictures;
}

SessionReplay openReplay(const fs::path& folder) {
  SessionReplay replay;
  replay.track = casefile::readSessionTrack(folder / "poses.csv", folder / "guidance.csv");
  if (replay.track.moments.empty())
    throw Error("poses.csv has no frames", folder.string(), "there is nothing to replay");
  replay.pictures_words = "no pictures were kept with the session";
  for (const fs::path& recording : {folder / "recording", folder, casefile::evidenceFolder(folder)}) {
    if (!fs::exists(recording / "stereo.yml")) continue;
    try {
      if (recording == casefile::evidenceFolder(folder)) mendUnlessRunning(folder);
      replay.pictures = openPictures(recording, replay.track);
      replay.pictures_words.clear();
    } catch (const Error& error) {
      replay.pictures_words = error.what();
    }
    break;
  }
  return replay;
}

std::string lossAt(const casefile::SessionTrack& track, const casefile::TrackMoment& moment) {
  if (!moment.has_head) return "face lost: " + track.word(moment.head_reason);
  if (!moment.has_coil) return "coil lost: " + track.word(moment.coil_reason);
  if (!track.is_in_mri) return "the poses are not aligned with the MRI";
  if (!track.is_coil) return "the poses are those of the marker, not of the coil";
  return {};
}

}  // namespace facenav::steps
