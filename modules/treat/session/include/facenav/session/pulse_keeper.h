#pragma once
// PulseKeeper: keeps the pulses of a running session in its pulses.jsonl, on its own thread, so that neither
// tracking nor a caller waits for the disk. A pulse waits for the frame after it (kLongestWait_s), so that
// its pose can be interpolated, and is then written and synced. Pulses that cannot be written stay in memory
// and are tried again twice a second.

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "facenav/session/pulse_pose.h"

namespace facenav::session {

/// Pulses by their verdict; together those whose frames have come.
struct PulseCounts {
  int on_target = 0, outside = 0, lost = 0;
};
/// The newest pulse with a verdict.
struct JudgedPulse {
  int number = 0;
  casefile::PulseStatus status = casefile::PulseStatus::lost;
  std::string reason;  // in words; empty: on target
};

class PulseKeeper {
 public:
  /// Told of each pulse when it has its pose and number, before it is on the disk; must return at once and
  /// call nothing of the keeper.
  using Placed = std::function<void(const casefile::Pulse&)>;
  /// Makes pulses.jsonl; or, with `goes_on`, appends to that of an earlier session: numbers and counts go on.
  /// `scalp`: for the gap; may be null. Throws Error if the file cannot be made.
  explicit PulseKeeper(const std::filesystem::path& session_folder,
                       std::shared_ptr<const registration::ScalpField> scalp = nullptr, bool goes_on = false,
                       Placed placed = {});
  /// Writes what still waits, without a frame after it if need be.
  ~PulseKeeper();
  PulseKeeper(const PulseKeeper&) = delete;
  PulseKeeper& operator=(const PulseKeeper&) = delete;

  /// Returns at once. False: a second trigger of this source within its dead time, before or after the last
  /// one; not counted.
  bool add(const PulseTrigger& trigger);
  /// A new frame; returns at once.
  void follow(const NavigationState& state);
  /// Verdicts are known about one frame after the pulse, before it is on the disk.
  PulseCounts counts() const;
  std::optional<JudgedPulse> last() const;
  /// The number of the newest pulse taken by add().
  int added() const;
  /// The number of the newest pulse that is in the file, synced; all before it are there, too.
  int kept() const;
  /// The pulses that came to the file since the last call, at most kMostTold of them, for a caller that tells
  /// them on.
  std::vector<casefile::Pulse> takeKept();
  static constexpr std::size_t kMostTold = 1000;
  /// Pulses that are not there yet: they wait for a frame or for the disk.
  int waiting() const;
  /// Why pulses cannot be written now; empty: they can.
  std::string failure() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::session
