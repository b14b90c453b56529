#pragma once
// Visits of the virtual room for `facenav evaluate return`: how one is aligned, what it sees of the coil, and
// how far that coil is from where the expert held it.

#include <memory>
#include <string>
#include <vector>

#include "evaluate/return_run.h"
#include "facenav/align/align_from_capture.h"
#include "facenav/coil_tracking/coil_tracker.h"
#include "facenav/room/synthetic_source.h"

namespace facenav::app {

/// A visit that differs from the first.
struct Change {
  const char* words;
  room::ScenarioOptions options;
};

/// How the later visits are aligned: from dense dots, or from one plain picture with the coil's marker in it.
enum class VisitPictures { dots, plain_with_marker };

room::ScenarioOptions firstVisit(std::uint64_t seed, int frames, VisitPictures pictures);
std::vector<Change> laterVisits(std::uint64_t seed, int frames, VisitPictures pictures);

using CoilPoses = std::vector<RigidTransform<Mri, Coil>>;

/// What a visit saw: the coil as measured and as it truly was, in step.
struct Seen {
  CoilPoses measured, truth;
};

RigidTransform<Mri, Coil> medianPose(const CoilPoses& poses);

/// The skin that a later visit aligns to, and the expert's pose in its frame.
struct ReturnModel {
  std::string name;
  surface::ScalpSurface skin;
  RigidTransform<Mri, Coil> expert;
  VisitPictures pictures = VisitPictures::dots;  // of the later visits
};

struct ReturnBench {
  Context& context;
  std::unique_ptr<registration::Aligner> aligner;
  std::shared_ptr<const face::FaceDetector> detector;
  std::unique_ptr<coil_tracking::CoilTracker> marker_finder;

  /// The pictures of a visit that it is aligned from.
  static capture::CapturePair capture(room::SyntheticSource& room, VisitPictures pictures);
  /// `expert`: where the error is stated.
  steps::AlignmentOutcome align(const cameras::StereoRig& rig, const room::SyntheticSource& room,
                                const capture::CapturePair& pair, VisitPictures pictures,
                                const surface::ScalpSurface& skin,
                                const RigidTransform<Mri, Coil>& expert) const;
  /// The frames after `least_share` of the room's film.
  Seen follow(room::SyntheticSource& room, const cameras::StereoRig& rig,
              const steps::AlignmentOutcome& alignment, double least_share) const;
};

/// What nobody knows of the right camera: whether it turned since the calibration. A turn about its vertical
/// axis (`sideways_deg`) shows in no match.
struct Knock {
  bool is_any_axis = false;  // by 0.3 deg, about an axis that the seed draws
  double sideways_deg = 0.0;
};
/// The calibration from before the knock.
cameras::StereoRig beforeKnock(cameras::StereoRig rig, std::uint64_t seed, Knock knock);

ReturnRun visitAgain(const ReturnBench& bench, const ReturnModel& model, const EvaluationHead& person,
                     const Change& change, const RigidTransform<Mri, Coil>& true_expert, Knock knock);

}  // namespace facenav::app
