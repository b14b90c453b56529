#include "support/room_film.h"

#include "facenav/align/align_from_capture.h"

namespace facenav::testing {
namespace {

coil_tracking::CoilModel modelOf(const room::RoomCoil& coil) {
  coil_tracking::CoilModel model = coil_tracking::defaultCoil();
  model.markers.front().dictionary = coil.dictionary;
  model.markers.front().id = coil.marker_id;
  model.markers.front().size_mm = coil.marker_size_mm;
  model.markers.front().coil_T_marker = coil.marker_T_coil.inverse();
  return model;
}

/// Makes the reference: the face measured from the capture pair with dots, in the plain pair's frame.
head_tracking::HeadReference referenceOf(const cameras::StereoRig& rig, const capture::CapturePair& pair,
                                         const face::FaceDetector& detector) {
  TaskMonitor monitor;
  const auto landmarks = measured_face::findFace(rig, pair.plain, detector);
  const auto face = measured_face::cutFace(stereo::measureFace(rig, pair.pattern, {}, monitor), landmarks);
  return {pair.plain, face.cloud, face.left_px};
}

}  // namespace

double RoomFilm::errorAtTarget_mm(const head_tracking::HeadPose& pose, std::size_t frame) const {
  const auto camera_T_mri = pose.camera_T_head * at_reference.reframe<Head, Mri>();
  return ((camera_T_mri * target).mm - (truth[frame].camera_T_mri * target).mm).norm();
}

RoomFilm filmed(const room::ScenarioOptions& options, std::shared_ptr<const room::VirtualPatient> patient,
                const face::FaceDetector& detector) {
  room::SyntheticSource source(options, std::move(patient));
  RoomFilm film;
  film.rig = source.rig();
  film.coil = modelOf(source.coil());
  film.at_reference = source.captureTruth();
  film.target = source.target() * Point<frames::Target>(0.0, 0.0, 25.0);
  film.reference = referenceOf(film.rig, source.capturePair(), detector);
  while (auto frame = source.next()) {
    film.frames.push_back(frame);
    film.truth.push_back(source.truth());
  }
  return film;
}

}  // namespace facenav::testing
