#pragma once
// Recorder: keeps a session's frames as a recording folder (FORMATS.md), on a thread of its own behind a
// bounded queue: when the disk is too slow, frames are left out and counted; tracking never waits.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "facenav/cameras/stereo_frame.h"
#include "facenav/cameras/stereo_rig.h"

namespace facenav::session {

class Recorder {
 public:
  Recorder(const std::filesystem::path& folder, const cameras::StereoRig& rig, std::size_t queue_limit = 120);
  /// Without close(): nothing is left behind.
  ~Recorder();
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  /// Returns at once.
  void add(std::shared_ptr<const cameras::StereoFrame> frame);
  /// Writes what is queued and makes the folder visible. Safe to call twice. Never throws: see failure().
  void close();

  std::uint64_t written() const;
  /// Frames left out because the queue was full.
  std::uint64_t leftOut() const;
  /// Why writing stopped (disk full, ..); empty while all is well.
  std::string failure() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::session
