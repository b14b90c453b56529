#include "facenav/evaluation/frame_errors.h"

#include <algorithm>
#include <cmath>

#include "facenav/core/robust_statistics.h"
#include "facenav/geometry/rotation.h"

namespace facenav::evaluation {
namespace {

ErrorAt between(const Eigen::Isometry3d& estimated, const Eigen::Isometry3d& truth,
                const Eigen::Vector3d& point_mm) {
  return {(estimated * point_mm - truth * point_mm).norm(),
          kDegPerRad * rotationAngle(estimated.linear().transpose() * truth.linear())};
}

bool isWrong(const std::optional<ErrorAt>& error) {
  return error && (error->mm > kWrong_mm || error->deg > kWrong_deg);
}

void addHead(const RunRecord& run, const FrameRecord& frame, FrameErrors& errors) {
  if (!frame.head_motion) return;
  if (!frame.truth.head) {
    errors.is_head_wrong = true;  // another person or object is tracked as the patient
    return;
  }
  errors.motion = between(*frame.head_motion * run.true_reference, *frame.truth.head, run.target_mm);
  errors.head = errors.motion;
  if (run.alignment && run.alignment->refusal.empty())
    errors.head = between(*frame.head_motion * run.alignment->estimated, *frame.truth.head, run.target_mm);
  errors.is_head_wrong = isWrong(errors.head);
}

void addCoil(const FrameRecord& frame, FrameErrors& errors) {
  if (frame.truth.marker) {
    const Eigen::Vector3d at_mm = frame.truth.marker->translation(),
                          into = frame.truth.marker->linear().col(2);
    errors.coil_distance_mm = at_mm.norm();
    errors.coil_tilt_deg = kDegPerRad * std::acos(std::clamp(into.dot(at_mm.normalized()), -1.0, 1.0));
  }
  if (!frame.marker) return;
  if (frame.truth.marker) errors.coil = between(*frame.marker, *frame.truth.marker, Eigen::Vector3d::Zero());
  errors.is_coil_wrong = !frame.truth.marker || isWrong(errors.coil);
}

/// Error of the cortical target, carried along with the coil, in the head's frame.
ErrorAt ofCoilInHead(const RunRecord& run, const FrameRecord& frame, const Eigen::Isometry3d& head_T_mri) {
  const Eigen::Isometry3d true_mri_T_coil =
      frame.truth.head->inverse() * *frame.truth.marker * run.marker_T_coil;
  const Eigen::Isometry3d mri_T_coil =
      (*frame.head_motion * head_T_mri).inverse() * *frame.marker * run.marker_T_coil;
  return between(mri_T_coil, true_mri_T_coil, true_mri_T_coil.inverse() * run.target_mm);
}

void addRelative(const RunRecord& run, const FrameRecord& frame, FrameErrors& errors) {
  if (!frame.head_motion || !frame.marker || !frame.truth.head || !frame.truth.marker) return;
  errors.relative_motion = ofCoilInHead(run, frame, run.true_reference);
  errors.relative = errors.relative_motion;
  if (run.alignment && run.alignment->refusal.empty())
    errors.relative = ofCoilInHead(run, frame, run.alignment->estimated);
}

double medianVisible(const RunRecord& run) {
  std::vector<double> visible;
  for (const auto& frame : run.frames)
    if (!frame.truth.must_be_lost) visible.push_back(frame.truth.face_visible_fraction);
  return upperMedian(std::move(visible));
}

}  // namespace

std::vector<FrameErrors> frameErrors(const RunRecord& run) {
  std::vector<FrameErrors> all;
  all.reserve(run.frames.size());
  for (const FrameRecord& frame : run.frames) {
    FrameErrors errors;
    addHead(run, frame, errors);
    addCoil(frame, errors);
    addRelative(run, frame, errors);
    all.push_back(errors);
  }
  return all;
}

double longestLoss_s(const RunRecord& run) {
  const double enough = 0.5 * medianVisible(run);
  int now = 0, longest = 0;
  for (const auto& frame : run.frames) {
    const bool is_knowable = !frame.truth.must_be_lost && frame.truth.head;
    if (frame.head_motion || !is_knowable)
      now = 0;
    else if (now > 0 || frame.truth.face_visible_fraction >= enough)
      longest = std::max(longest, ++now);
  }
  return longest / run.frames_per_s;
}

std::vector<double> timesToFindAgain_s(const RunRecord& run) {
  const double enough = 0.5 * medianVisible(run);
  std::vector<double> times_s;
  bool is_gone = false, is_waiting = false;
  int waited = 0;
  for (const auto& frame : run.frames) {
    const bool is_unknowable = frame.truth.must_be_lost || !frame.truth.head;
    if (is_unknowable) {
      if (is_waiting && waited > 0) times_s.push_back(waited / run.frames_per_s);
      is_gone = true, is_waiting = false, waited = 0;
      continue;
    }
    if (is_gone && frame.truth.face_visible_fraction >= enough)
      is_gone = false, is_waiting = true, waited = 0;
    if (!is_waiting) continue;
    if (frame.head_motion) {
      times_s.push_back(waited / run.frames_per_s);
      is_waiting = false;
    } else {
      ++waited;
    }
  }
  if (is_waiting) times_s.push_back(waited / run.frames_per_s);
  return times_s;
}

double jitter_mm(const RunRecord& run) {
  std::vector<Eigen::Vector3d> places;
  for (const auto& frame : run.frames)
    if (frame.head_motion) places.push_back(*frame.head_motion * run.true_reference * run.target_mm);
  if (places.size() < 2) return 0.0;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const auto& p : places) mean += p / double(places.size());
  double squares = 0.0;
  for (const auto& p : places) squares += (p - mean).squaredNorm();
  return std::sqrt(squares / double(places.size() - 1));
}

std::optional<std::size_t> cameraNoticedAt(const RunRecord& run) {
  for (std::size_t i = 0; i < run.frames.size(); ++i)
    if (run.frames[i].is_camera_noticed) return i;
  return std::nullopt;
}

}  // namespace facenav::evaluation
