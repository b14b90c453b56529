#pragma once
// WorldRoom: renders a World: the capture's pictures, then frames of two moments with a gap between them, and
// the truth. Everything is determined by the world and the fault.

#include <memory>

#include "facenav/cameras/stereo_frame.h"
#include "facenav/capture/recording.h"
#include "facenav/room/world.h"

namespace facenav::room {

/// Frames of the two moments, their rate, and the time between the moments.
constexpr int kFirstFrames = 6, kSecondFrames = 9;
constexpr double kWorldFrames_per_s = 30.0, kWorldGap_s = 1.5;

/// The cameras as they stand.
cameras::StereoRig trueRig(const World& world);
/// The cameras as a calibration with the world's board views finds them, with its standard errors.
cameras::StereoRig calibratedRig(const World& world, const cameras::StereoRig& truth);

class WorldRoom {
 public:
  WorldRoom(const World& world, const DrawnFault& fault, std::shared_ptr<const VirtualPatient> person);
  ~WorldRoom();

  /// The still pair; `pattern` is empty where the projector is off.
  capture::CapturePair capture();
  static constexpr int frameCount() { return kFirstFrames + kSecondFrames; }
  /// Renders a frame. Frames must come in order (a frozen camera repeats).
  cameras::StereoFrame frame(int number);

  RigidTransform<Camera, Mri> captureTruth() const;
  /// camera_T_mri at the frame's left exposure.
  RigidTransform<Camera, Mri> truth(int number) const;
  /// Share of the face's skin that both cameras see in the last frame that was rendered, 0..1.
  double faceVisibleFraction() const;
  /// Pose of the right camera at the frame (-1: at the capture), by the truth.
  RigidTransform<RightCamera, Camera> right_T_left(int number) const;
  static bool isSecond(int number) { return number >= kFirstFrames; }

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::room
