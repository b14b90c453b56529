#pragma once
// One trial of `facenav evaluate gates`: a drawn world, with a fault or without, goes through the steps of
// `facenav track`: the case's scan, the capture pair, the frames. The row says what the program gave, and
// what was true.

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "evaluate/gate_heads.h"
#include "facenav/room/world_room.h"

namespace facenav::app {

struct GateRow {
  room::World world;
  room::DrawnFault fault;
  std::string head;
  double calibration_px = 0.0;  // rms of the calibration
  double size_measured = 1.0;   // size at which exact matches measure the head at the capture

  bool is_accepted = false;   // aligned and started
  bool is_confirmed = false;  // asked who the patient is, and answered as it is: yes
  std::string refusal;        // else the program's words
  std::string from;           // "dots", "plain", "film"
  double start_mm = 0.0, start_deg = 0.0, bound_mm = 0.0;  // at the target; bound: 95 %, as stated
  /// Refused: does tracking alone, without the scan, start? Its share of tracked frames; -1: not tried, or
  /// refused too.
  double tracked_alone = -1.0;
  std::string refusal_alone;

  int visible = 0, tracked = 0;                // frames with a visible face, and those with a pose
  int second_visible = 0, second_tracked = 0;  // of them after the gap
  bool is_found_again = false;                 // within 0.2 s after the gap
  std::vector<double> errors_mm;               // of the frames with a pose, at the target
  int over_tolerance = 0;                      // poses more than 3 mm or 2 deg off
  int wrong_shown = 0;                         // over the tolerance and over the stated bound
  std::string losses;                          // "no_face:doubtful x3"
  std::set<std::string> named;                 // faults that the program named
  bool is_delay_found = false;                 // out of step: the delay is measured, within a half of it
  double room_s = 0.0, product_s = 0.0;        // processor time

  bool isInsideBound() const { return is_accepted && start_mm <= bound_mm; }
  /// False if the fault begins after the gap, and the start was refused: nothing was shown of it.
  bool isFaultSeen() const { return fault.is_from_start || is_accepted; }
  /// True if every fault that was named is the right one. Without a fault: none was named.
  bool isNamedRightly() const;
  bool isNamed() const { return !named.empty() || is_delay_found; }
};

/// Runs the trial. `folder`: for its recording and its case; both stay there.
GateRow runGateTrial(Context& context, GateHeads& heads, std::uint64_t seed, room::WorldFault fault,
                     const std::filesystem::path& folder);

}  // namespace facenav::app
