#include "evaluate/rig_faults.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <opencv2/imgcodecs.hpp>

#include "evaluate/camera_pictures.h"
#include "facenav/cameras/rig_file.h"
#include "facenav/core/error.h"
#include "facenav/geometry/rotation.h"
#include "facenav/health/pair_matches.h"

namespace facenav::app {
namespace fs = std::filesystem;
namespace {

using health::RigState;
using Matches = std::vector<health::Correspondence>;

/// Pairs of pictures, each matched once for all calibrations, as in diagnosePair.
class MatchedPictures {
 public:
  explicit MatchedPictures(const std::map<std::string, fs::path>& files) : files_(files) {}

  const Matches& corners(const std::string& left, const std::string& right) {
    const auto [found, is_new] = corners_.try_emplace({left, right});
    if (is_new) found->second = health::matchPictures(picture(left), picture(right));
    return found->second;
  }
  const Matches& skin(const std::string& left, const std::string& right) {
    const auto [found, is_new] = skin_.try_emplace({left, right});
    if (is_new) found->second = health::growMatches(picture(left), picture(right), corners(left, right));
    return found->second;
  }

 private:
  cv::Mat picture(const std::string& name) const {
    return cv::imread(files_.at(name).string(), cv::IMREAD_GRAYSCALE);
  }

  const std::map<std::string, fs::path>& files_;
  std::map<std::pair<std::string, std::string>, Matches> corners_, skin_;
};

struct Trial {
  std::string kind, left, right, calibration;  // left, right: "l_418"
  RigState expected;
  cameras::StereoRig rig;
};

cameras::StereoRig moved(const cameras::StereoRig& rig, const Eigen::Vector3d& turn_deg,
                         const Eigen::Vector3d& shift_mm) {
  cameras::StereoRig other = rig;
  Eigen::Isometry3d pose = rig.right_T_left.isometry();
  pose.prerotate(expRotation(turn_deg * kRadPerDeg));
  pose.pretranslate(shift_mm);
  other.right_T_left = RigidTransform<RightCamera, Camera>::fromIsometry(pose);
  return other;
}

void addMoved(const Trial& right_rig, std::vector<Trial>& trials) {
  const auto add = [&](const std::string& kind, const Eigen::Vector3d& turn_deg,
                       const Eigen::Vector3d& shift_mm) {
    Trial trial = right_rig;
    trial.kind = kind;
    trial.expected = RigState::moved;
    trial.rig = moved(right_rig.rig, turn_deg, shift_mm);
    trials.push_back(trial);
  };
  for (const double deg : {0.05, 0.1, 0.25, 0.5}) {
    char size[32];
    std::snprintf(size, sizeof size, "%.2f deg", deg);
    add(std::string("pitched ") + size, {deg, 0, 0}, {0, 0, 0});
    add(std::string("rolled ") + size, {0, 0, deg}, {0, 0, 0});
  }
  add("shifted up 1 mm", {0, 0, 0}, {0, 1, 0});
  add("shifted up 3 mm", {0, 0, 0}, {0, 3, 0});
}

std::vector<Trial> trialsOf(const std::map<std::string, fs::path>& files,
                            const std::map<std::string, cameras::StereoRig>& rigs) {
  std::vector<Trial> trials;
  for (const auto& [name, rig] : rigs) {
    std::vector<std::string> moments;
    for (const auto& moment : momentsOf(files, name[0], name[1])) moments.push_back("_" + moment);
    for (const auto& moment : moments) {
      const Trial as_is{"right rig", name[0] + moment, name[1] + moment, name, RigState::holds, rig};
      trials.push_back(as_is);
      for (const auto& other : moments)
        if (other != moment)
          trials.push_back({"out of step", as_is.left, name[1] + other, name, RigState::out_of_step, rig});
      trials.push_back({"swapped", as_is.right, as_is.left, name, RigState::swapped, rig});
      for (const auto& [other, other_rig] : rigs)
        if (other != name)
          trials.push_back({"other rig", as_is.left, as_is.right, other, RigState::other_cameras, other_rig});
      addMoved(as_is, trials);
    }
  }
  return trials;
}

std::string wordOf(RigState fault) {
  switch (fault) {
    case RigState::holds:
      return "none";
    case RigState::out_of_step:
      return "out of step";
    case RigState::swapped:
      return "swapped";
    case RigState::moved:
      return "moved";
    case RigState::other_cameras:
      return "other rig";
    case RigState::disagree:
      return "moved or out of step";
    case RigState::unclear:
    case RigState::away:
      break;
  }
  return "unknown";
}

}  // namespace

std::vector<RigFaultRow> rigFaults(const fs::path& pictures, const fs::path& rigs, TaskMonitor& monitor) {
  const auto files = picturesIn(pictures);
  const auto trials = trialsOf(files, rigsIn(rigs));
  if (trials.empty())
    throw Error("no pictures of a rig's two cameras are found", pictures.string(),
                "name them <camera>_<moment>.jpg, and the rigs <a><b>_stereo.yml");
  MatchedPictures matched(files);
  std::vector<RigFaultRow> rows;
  for (const auto& trial : trials) {
    monitor.report("rigs: " + trial.kind, double(rows.size()) / double(trials.size()));
    auto said = health::diagnoseMatches(trial.rig, matched.corners(trial.left, trial.right));
    if (said.isOfCameras()) said = health::withSkin(trial.rig, said, matched.skin(trial.left, trial.right));
    rows.push_back(
        {trial.kind, trial.left + " " + trial.right, trial.calibration, trial.expected, std::move(said)});
  }
  return rows;
}

std::string sidesTable(const std::vector<RigFaultRow>& rows) {
  std::vector<std::string> kinds;
  for (const auto& row : rows)
    if (std::find(kinds.begin(), kinds.end(), row.kind) == kinds.end()) kinds.push_back(row.kind);
  std::string text = "| kind | tried | named rightly | silent | named otherwise |\n|---|---|---|---|---|\n";
  char line[240];
  for (const auto& kind : kinds) {
    int tried = 0, right = 0, silent = 0;
    for (const auto& row : rows) {
      if (row.kind != kind) continue;
      ++tried;
      right += row.said.state == row.expected;
      silent += row.said.state != row.expected && !row.said.isFault();
    }
    std::snprintf(line, sizeof line, "| %s | %d | %d | %d | %d |\n", kind.c_str(), tried, right, silent,
                  tried - right - silent);
    text += line;
  }
  text +=
      "\n| kind | pictures | calibration | said | matches | off by px | agree | agree when explained | skin "
      "px "
      "|\n|---|---|---|---|---|---|---|---|---|\n";
  for (const auto& row : rows) {
    if (row.said.state == row.expected) continue;
    std::snprintf(line, sizeof line, "| %s | %s | %s | %s | %zu | %.2f | %.2f | %.2f | %.2f |\n",
                  row.kind.c_str(), row.pictures.c_str(), row.calibration.c_str(),
                  wordOf(row.said.state).c_str(), row.said.matches, row.said.residual_px,
                  row.said.calibrated_agreement, row.said.agreement, row.said.skin_px);
    text += line;
  }
  return text;
}

}  // namespace facenav::app
