#pragma once
// PulseKeeper: writes the pulses of a running session to its pulses.jsonl, on its own thread, so that neither
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

/// Number of pulses by verdict; together those whose frames have arrived.
struct PulseCounts {
  int on_target = 0, outside = 0, lost = 0;
};
/// A pulse as it was accepted, before its verdict is known.
struct AddedPulse {
  int number = 0;  // 0: none yet
  std::optional<double> intensity_pct;
};
/// The newest pulse with a verdict.
struct JudgedPulse {
  int number = 0;
  casefile::PulseStatus status = casefile::PulseStatus::lost;
  std::string reason;  // in words; empty: on target
};

class PulseKeeper {
 public:
  /// Callback for each pulse when it has its pose and number, before it is on the disk. Must return at once
  /// and call nothing of the keeper.
  using Placed = std::function<void(const casefile::Pulse&)>;
  /// Makes pulses.jsonl; with `goes_on`, appends to that of an earlier session and continues its numbers and
  /// counts. `scalp`: for the gap; may be null. Throws Error if the file cannot be made.
  explicit PulseKeeper(const std::filesystem::path& session_folder,
                       std::shared_ptr<const registration::ScalpField> scalp = nullptr, bool goes_on = false,
                       Placed placed = {});
  /// Writes all pulses, without a frame after them if need be.
  ~PulseKeeper();
  PulseKeeper(const PulseKeeper&) = delete;
  PulseKeeper& operator=(const PulseKeeper&) = delete;

  /// Adds a pulse; returns at once. Returns false for a second trigger of this source within its dead time,
  /// before or after the last one; that is not counted.
  bool add(const PulseTrigger& trigger);
  /// Adds a frame; returns at once.
  void follow(const NavigationState& state);
  /// Counts by verdict. A verdict is known about one frame after the pulse, before it is on the disk.
  PulseCounts counts() const;
  std::optional<JudgedPulse> last() const;
  /// Number of the newest pulse accepted by add().
  int added() const;
  /// The newest pulse accepted by add() in this run; number 0: none.
  AddedPulse newest() const;
  /// Number of the newest pulse that is in the file, synced; all before it are there, too.
  int kept() const;
  /// Returns the pulses written since the last call, at most kMostTold of them, to forward them.
  std::vector<casefile::Pulse> takeKept();
  static constexpr std::size_t kMostTold = 1000;
  /// Number of pulses not yet written: they wait for a frame or for the disk.
  int waiting() const;
  /// Fault that prevents writing now; empty: none.
  std::string failure() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::session
