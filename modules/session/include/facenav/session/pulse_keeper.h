#pragma once
// PulseKeeper: keeps the pulses of a running session in its pulses.jsonl, on its own thread, so that neither
// tracking nor a caller waits for the disk. A pulse waits for the frame after it (kLongestWait_s), so that
// its pose can be interpolated, and is then written and synced. Pulses that cannot be written stay in memory
// and are tried again twice a second.

#include <filesystem>
#include <memory>
#include <string>

#include "facenav/session/pulse_pose.h"

namespace facenav::session {

class PulseKeeper {
 public:
  /// Makes pulses.jsonl. Throws Error if that fails.
  explicit PulseKeeper(const std::filesystem::path& session_folder);
  /// Writes what still waits, without a frame after it if need be.
  ~PulseKeeper();
  PulseKeeper(const PulseKeeper&) = delete;
  PulseKeeper& operator=(const PulseKeeper&) = delete;

  /// Returns at once. False: a second trigger of this source within its dead time, not counted.
  bool add(const PulseTrigger& trigger);
  /// A new frame; returns at once.
  void follow(const NavigationState& state);
  /// Pulses that are in the file, synced.
  int kept() const;
  /// Pulses that are not there yet: they wait for a frame or for the disk.
  int waiting() const;
  /// Why pulses cannot be written now; empty: they can.
  std::string failure() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::session
