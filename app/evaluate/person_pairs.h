#pragma once
// `facenav evaluate pairs`: the head tracker on photographs of real people, where no truth is known. A person
// is tracked at one moment, lost for longer than a second, and comes back as at another moment; is the face
// found, how fast, and do two pairs of cameras that saw the same moments tell the same motion? Another
// person's pictures, the person's own mirrored, and pictures of two moments on the two sides must never be
// shown.

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "facenav/core/task_monitor.h"
#include "facenav/head_tracking/head_tracker.h"

namespace facenav::app {

struct PairTrial {
  enum class Kind { same_person, changed, other_person, mirrored, out_of_step };
  Kind kind = Kind::same_person;
  std::string rig, person, from, to;  // to: "418", or "418/835" of two moments; of whom, where it is another
  int frames = 0, shown = 0;          // after the loss
  std::optional<double> found_after_s;
  std::string detail;                           // of the last frame that was lost
  std::optional<head_tracking::HeadPose> pose;  // of the last frame shown; its left camera is the rig's
};

/// What two pairs of cameras that share one tell of the same motion, in the shared camera.
struct PairAgreement {
  std::string person, from, to, rigs;
  double turn_deg = 0, shift_mm = 0;  // of the motion
  double off_deg = 0, off_mm = 0;     // of one pair's motion against the other's, 80 mm behind the face
  bool is_inside = false;             // the 95 % bound that both state
};

struct PairsResult {
  std::vector<PairTrial> trials;
  std::vector<PairAgreement> agreements;
};

/// `people`: a folder each (camera_pictures.h), `rigs`: of all. `make`: a tracker for each trial. Throws
/// Error where no rig finds pictures, Cancelled.
PairsResult evaluatePairs(const std::vector<std::filesystem::path>& people, const std::filesystem::path& rigs,
                          const std::function<std::unique_ptr<head_tracking::HeadTracker>()>& make,
                          TaskMonitor& monitor);

/// As Markdown: the goals' table, a table by moment, then every trial that went wrong.
std::string pairsTable(const PairsResult& result);

}  // namespace facenav::app
