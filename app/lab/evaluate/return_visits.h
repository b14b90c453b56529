#pragma once
// Visits of the virtual room for `facenav evaluate return`: how one is aligned, its measured coil poses, and
// their distance from where the expert held the coil.

#include <memory>
#include <string>
#include <vector>

#include "evaluate/return_run.h"
#include "facenav/align/align_from_capture.h"
#include "facenav/coil_tracking/coil_tracker.h"
#include "facenav/room/synthetic_source.h"

namespace facenav::app {

/// Differences of a visit from the first.
struct Change {
  const char* words;
  room::ScenarioOptions options;
};

/// Pictures that the later visits are aligned from: dense dots, or one plain picture with the coil's marker.
enum class VisitPictures { dots, plain_with_marker };

room::ScenarioOptions firstVisit(std::uint64_t seed, int frames, VisitPictures pictures);
std::vector<Change> laterVisits(std::uint64_t seed, int frames, VisitPictures pictures);

using CoilPoses = std::vector<RigidTransform<Mri, Coil>>;

/// Measured and true coil poses of a visit, at the same frames.
struct Seen {
  CoilPoses measured, truth;
};

RigidTransform<Mri, Coil> medianPose(const CoilPoses& poses);

/// The skin that a later visit aligns to, and the expert's pose in its frame.
struct ReturnModel {
  std::string name;
  surface::ScalpSurface skin;
  RigidTransform<Mri, Coil> expert;
  VisitPictures pictures = VisitPictures::dots;  // pictures of the later visits
};

struct ReturnBench {
  Context& context;
  std::unique_ptr<registration::Aligner> aligner;
  std::shared_ptr<const face::FaceDetector> detector;
  std::unique_ptr<coil_tracking::CoilTracker> marker_finder;

  /// Takes the pictures that a visit is aligned from.
  static capture::CapturePair capture(room::SyntheticSource& room, VisitPictures pictures);
  /// Aligns; `expert`: where the error is evaluated.
  steps::AlignmentOutcome align(const cameras::StereoRig& rig, const room::SyntheticSource& room,
                                const capture::CapturePair& pair, VisitPictures pictures,
                                const surface::ScalpSurface& skin,
                                const RigidTransform<Mri, Coil>& expert) const;
  /// Tracks the frames after `least_share` of the room's film.
  Seen follow(room::SyntheticSource& room, const cameras::StereoRig& rig,
              const steps::AlignmentOutcome& alignment, double least_share) const;
};

/// Unnoticed rotation of the right camera since the calibration. One about its vertical axis (`sideways_deg`)
/// does not show in matches.
struct Knock {
  bool is_any_axis = false;  // rotated by 0.3 deg about an axis drawn from the seed
  double sideways_deg = 0.0;
};
/// The calibration before the rotation.
cameras::StereoRig beforeKnock(cameras::StereoRig rig, std::uint64_t seed, Knock knock);

ReturnRun visitAgain(const ReturnBench& bench, const ReturnModel& model, const EvaluationHead& person,
                     const Change& change, const RigidTransform<Mri, Coil>& true_expert, Knock knock);

}  // namespace facenav::app
