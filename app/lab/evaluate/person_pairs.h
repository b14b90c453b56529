#pragma once
// `facenav evaluate pairs`: the head tracker on photographs of real people, without truth. A person is
// tracked at one moment, is lost for longer than a second, and returns as at another moment. It measures
// whether and how fast the face is found, and whether two pairs of cameras that saw the same moments measure
// the same motion. Another person's images, mirrored images, and images of two moments on the two sides must
// never give a pose.

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
  // `to`: "418", or "418/835" for two moments; with the name if it is another person.
  std::string rig, person, from, to;
  int frames = 0, shown = 0;  // after the loss
  std::optional<double> found_after_s;
  std::string detail;                           // of the last lost frame
  std::optional<head_tracking::HeadPose> pose;  // of the last tracked frame; its left camera is the rig's
};

/// One motion measured by two pairs of cameras that share one camera, in that camera.
struct PairAgreement {
  std::string person, from, to, rigs;
  double turn_deg = 0, shift_mm = 0;  // size of the motion
  double off_deg = 0, off_mm = 0;     // difference between the two motions, 80 mm behind the face
  bool is_inside = false;             // within the 95 % bound of both covariances
};

struct PairsResult {
  std::vector<PairTrial> trials;
  std::vector<PairAgreement> agreements;
};

/// Runs the trials. `people`: one folder each (camera_pictures.h). `rigs`: folder of the rigs. `make`: makes
/// a tracker for each trial. Throws Error if no rig has images, Cancelled.
PairsResult evaluatePairs(const std::vector<std::filesystem::path>& people, const std::filesystem::path& rigs,
                          const std::function<std::unique_ptr<head_tracking::HeadTracker>()>& make,
                          TaskMonitor& monitor);

/// Formats as Markdown: the goals' table, a table by moment, then every trial that failed.
std::string pairsTable(const PairsResult& result);

}  // namespace facenav::app
