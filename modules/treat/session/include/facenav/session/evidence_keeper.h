#pragma once
// EvidenceKeeper: keeps both pictures of each pulse's frame (casefile/evidence.h), on its own thread behind a
// bounded queue: neither tracking nor the pulses wait for it. A full disk ends nothing: it is said by
// failure(), the pictures of that time are left out and counted, and later ones are kept again.

#include <filesystem>
#include <memory>
#include <string>

#include "facenav/cameras/stereo_rig.h"
#include "facenav/casefile/pulse.h"
#include "facenav/session/navigation_state.h"

namespace facenav::session {

class EvidenceKeeper {
 public:
  EvidenceKeeper(const std::filesystem::path& session_folder, const cameras::StereoRig& rig);
  /// Writes what still waits.
  ~EvidenceKeeper();
  EvidenceKeeper(const EvidenceKeeper&) = delete;
  EvidenceKeeper& operator=(const EvidenceKeeper&) = delete;

  /// A new frame with its pictures; returns at once.
  void follow(const NavigationState& state);
  /// A pulse with its frames: the pictures of the nearer one are kept. Returns at once.
  void add(const casefile::Pulse& pulse);
  /// Frames on the disk.
  int kept() const;
  /// Frames that were left out: the queue or the disk was full, or the frame was gone.
  int leftOut() const;
  /// Why pictures cannot be written now; empty: they can.
  std::string failure() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::session
