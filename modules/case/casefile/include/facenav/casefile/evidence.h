#pragma once
// Evidence of a session's pulses: both pictures of the frame nearest to each pulse, in the session's
// evidence/. The folder is a recording (resources/doc/formats.md: stereo.yml, timestamps.csv, left/, right/,
// here as JPEG), with the frame numbers and times of poses.csv, so that replay shows it and `facenav track`
// solves the poses again. These are photographs of the patient's face: files 0600, folders 0700.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

#include "facenav/cameras/stereo_frame.h"
#include "facenav/cameras/stereo_rig.h"
#include "facenav/casefile/pulse.h"
#include "facenav/core/setting.h"

namespace facenav::casefile {

struct EvidenceRules {
  static constexpr const char* kModule = "casefile";
  static constexpr const char* kSubject = "pictures kept with each pulse";

  int jpeg_quality = 90;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(kQuality("jpeg_quality", 0, 100, "1", "quality of a pulse's pictures; 0: none are kept"),
            self.jpeg_quality);
  }

  static constexpr Evidence kQuality{
      Origin::chosen,
      "about a fifth of a PNG's size; an eye sees no difference, and the poses can be solved again"};
};

class EvidenceFolder {
 public:
  /// Writes nothing before the first keep(), which also repairs what a crash left of an earlier run.
  EvidenceFolder(std::filesystem::path session_folder, const cameras::StereoRig& rig);
  ~EvidenceFolder();
  EvidenceFolder(const EvidenceFolder&) = delete;
  EvidenceFolder& operator=(const EvidenceFolder&) = delete;

  /// Stores both pictures under the frame number and time of poses.csv. Returns false if this frame or a
  /// later one is stored already (frame numbers of a recording rise). Throws Error (disk full, ..); then
  /// nothing of the frame is stored.
  bool keep(const cameras::StereoFrame& frame);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// Path of the session's evidence/; it may not exist.
std::filesystem::path evidenceFolder(const std::filesystem::path& session_folder);
/// Repairs evidence/ where a crash cut a frame short: removes pictures of one side alone and damaged lines.
/// Not for a running session. Throws Error.
void mendEvidence(const std::filesystem::path& session_folder);
/// Number of the frame whose pictures belong to the pulse; nothing if none were stored.
std::optional<std::int64_t> evidenceFrame(const std::filesystem::path& session_folder, const Pulse& pulse);

}  // namespace facenav::casefile
