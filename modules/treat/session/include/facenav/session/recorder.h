#pragma once
// Recorder: writes a session's frames as a recording folder (resources/doc/formats.md), on its own thread
// behind a bounded queue. When the disk is too slow, frames are dropped and counted; tracking never waits.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "facenav/cameras/stereo_frame.h"
#include "facenav/cameras/stereo_rig.h"
#include "facenav/core/file_access.h"

namespace facenav::capture {
struct CapturePair;
}

namespace facenav::session {

class Recorder {
 public:
  /// `capture`: still pair that goes with the recording; null: none.
  Recorder(const std::filesystem::path& folder, const cameras::StereoRig& rig, std::size_t queue_limit = 120,
           FileAccess access = FileAccess::owner_only, const capture::CapturePair* capture = nullptr);
  /// Removes the recording unless close() was called.
  ~Recorder();
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  /// Adds a frame; returns at once.
  void add(std::shared_ptr<const cameras::StereoFrame> frame);
  /// Writes the queue and makes the folder visible. Safe to call twice. Never throws: see failure().
  void close();

  std::uint64_t written() const;
  /// Number of frames dropped because the queue was full.
  std::uint64_t leftOut() const;
  /// Fault that stopped writing (disk full, ..); empty: none.
  std::string failure() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::session
