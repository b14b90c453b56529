#pragma once
// A session folder with known content: poses, guidance, events and pulses around a target; the face is lost
// for a while in the middle. For tests of review.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <random>
#include <vector>

#include "facenav/casefile/pulse_file.h"
#include "facenav/casefile/session_log.h"
#include "facenav/core/utc_time.h"
#include "facenav/guidance/guidance.h"

namespace facenav::testing {

struct MadeSession {
  int pulses = 40, frames = 600;                     // 50 frames a second
  int lost_from = 200, lost_to = 250;                // frames without the face
  Eigen::Vector3d off_mm = Eigen::Vector3d::Zero();  // offset of the coil, in Target
  double spread_mm = 1.2;                            // sigma, in x and y
  bool has_meps = false;                             // MEPs, larger the nearer the coil is to the target's +x
                                                     // side
  unsigned seed = 5;
};

/// Positions of the coil in each frame, in Target.
inline std::vector<Eigen::Vector3d> madeOffsets(const MadeSession& made) {
  std::mt19937 random(made.seed);
  std::normal_distribution<double> aside(0.0, made.spread_mm);
  std::vector<Eigen::Vector3d> offsets_mm;
  Eigen::Vector3d at_mm = made.off_mm;
  for (int n = 0; n < made.frames; ++n) {
    if (n % 15 == 0) at_mm = made.off_mm + Eigen::Vector3d(aside(random), aside(random), 0);
    offsets_mm.push_back(at_mm);
  }
  return offsets_mm;
}

/// Known content of the session's frames.
class MadeFrames {
 public:
  MadeFrames(const MadeSession& made, const guidance::Target& target)
      : made_(made), target_(target), offsets_mm_(madeOffsets(made)) {}
  bool isLost(int n) const { return n >= made_.lost_from && n < made_.lost_to; }
  double t_s(int n) const { return 50.0 + 0.02 * n; }
  const RigidTransform<Camera, Mri>& camera_T_mri() const { return camera_T_mri_; }
  Tracked<RigidTransform<Camera, Mri>> head(int n) const {
    if (isLost(n)) return Lost{LostReason::no_face};
    return {camera_T_mri_, 0.9};
  }
  RigidTransform<Camera, Coil> coil(int n) const {
    const RigidTransform<frames::Target, Coil> target_T_coil(Eigen::Quaterniond::Identity(), offset_mm(n));
    return camera_T_mri_ * target_.mri_T_target * target_T_coil;
  }
  const Eigen::Vector3d& offset_mm(int n) const { return offsets_mm_[std::size_t(n)]; }
  guidance::GuidanceState guidanceAt(int n) const {
    return guidance::evaluate(target_, head(n), Tracked<RigidTransform<Camera, Coil>>(coil(n), 0.9),
                              guidance::Tolerance{}, 0.8);
  }

 private:
  MadeSession made_;
  guidance::Target target_;
  std::vector<Eigen::Vector3d> offsets_mm_;
  RigidTransform<Camera, Mri> camera_T_mri_{
      Eigen::Quaterniond(Eigen::AngleAxisd(2.0, Eigen::Vector3d(1, 2, 3).normalized())), {10, -20, 600}};
};

/// Makes the pulse of that number, given in frame `n`.
inline casefile::Pulse madePulseOf(int number, int n, const MadeFrames& frames,
                                   const guidance::Target& target, bool has_mep) {
  casefile::Pulse pulse;
  pulse.number = number;
  pulse.t_s = frames.t_s(n);
  pulse.steady_s = 7000.0 + 0.02 * n;
  pulse.utc =
      isoUtc(std::chrono::system_clock::time_point(std::chrono::milliseconds(1795442400000LL + 20LL * n)));
  pulse.source = "keyboard";
  pulse.target = target;
  pulse.frames = {n, n + 1};
  pulse.camera_T_coil = frames.coil(n);
  pulse.intensity_pct = 55;
  pulse.predicted_error_mm = 0.8;
  pulse.reason = "face not seen";
  if (frames.isLost(n)) return pulse;
  const auto state = frames.guidanceAt(n);
  const auto& values = *state.values;
  const bool is_on_target = state.state == guidance::State::on_target;
  pulse.camera_T_mri = frames.camera_T_mri();
  pulse.offset = casefile::PulseOffset{values.distance_mm, values.lateral_mm, values.depth_mm,
                                       values.tilt_rad * 180.0 / M_PI, values.twist_rad * 180.0 / M_PI};
  pulse.status = is_on_target ? casefile::PulseStatus::on_target : casefile::PulseStatus::outside;
  pulse.reason = is_on_target ? "" : "2.7 mm beside the target (2.0 allowed)";
  const double beside_mm = frames.offset_mm(n).x() - 1.0;
  if (has_mep) pulse.mep_uv = std::round(400.0 * std::exp(-0.1 * beside_mm * beside_mm));
  return pulse;
}

inline std::filesystem::path writeMadeSession(const std::filesystem::path& case_folder,
                                              const guidance::Target& target, const MadeSession& made = {}) {
  casefile::SessionLog log(case_folder);
  for (const auto& [event, detail] : std::vector<std::pair<std::string, std::string>>{
           {"session started", ""},
           {"target", target.name},
           {"coil", "figure-8 70 mm"},
           {"alignment",
            "aligned: 95 % within 0.8 mm at " + target.name + " (0.41 mm rms over 16000 points)"},
           {"face lost", "no_face"},
           {"face found", ""}})
    log.addEvent(event, detail);
  const MadeFrames frames(made, target);
  for (int n = 0; n < made.frames; ++n) {
    const double t_s = frames.t_s(n);
    const Tracked<RigidTransform<Camera, Coil>> coil(frames.coil(n), 0.9);
    log.add(casefile::poseRow(n, t_s, casefile::PoseObject::head, frames.head(n)));
    log.add(casefile::poseRow(n, t_s, casefile::PoseObject::coil, coil));
    log.add(guidance::GuidanceRow{n, t_s, target.name, frames.guidanceAt(n)});
  }
  casefile::PulseFile file(log.folder());
  for (int i = 1; i <= made.pulses; ++i)
    file.keep(madePulseOf(i, (2 * i - 1) * made.frames / (2 * made.pulses), frames, target, made.has_meps));
  log.addEvent("session ended");
  return log.folder();
}

}  // namespace facenav::testing
