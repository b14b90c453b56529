#pragma once
// EvidenceKeeper: stores both pictures of each pulse's frame (casefile/evidence.h), on its own thread behind
// a bounded queue: neither tracking nor the pulses wait for it. With a full disk the session continues:
// failure() returns the fault, pictures are left out and counted until there is space again.

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
  /// Writes what is queued.
  ~EvidenceKeeper();
  EvidenceKeeper(const EvidenceKeeper&) = delete;
  EvidenceKeeper& operator=(const EvidenceKeeper&) = delete;

  /// Adds a frame with its pictures; returns at once.
  void follow(const NavigationState& state);
  /// Adds a pulse with its frames; the nearer one's pictures are stored. Returns at once.
  void add(const casefile::Pulse& pulse);
  /// Number of frames on the disk.
  int kept() const;
  /// Number of frames left out: the queue or the disk was full, or the frame was gone.
  int leftOut() const;
  /// Fault that prevents writing now; empty: none.
  std::string failure() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::session
