#pragma once
// SyntheticSource: a scenario as a live FrameSource. Each frame is rendered on request and has its truth.

#include <memory>
#include <optional>

#include "facenav/capture/frame_source.h"
#include "facenav/capture/recording.h"
#include "facenav/room/ground_truth.h"
#include "facenav/room/room_coil.h"
#include "facenav/room/scenario.h"
#include "facenav/stereo/dot_pattern.h"

namespace facenav::room {

class SyntheticSource : public capture::FrameSource {
 public:
  /// `target`: where the scenario `treatment` brings the coil; by default over the left hand area. Throws
  /// Error for an unknown scenario; the message lists the known ones.
  SyntheticSource(const ScenarioOptions& options, std::shared_ptr<const VirtualPatient> patient,
                  const std::optional<RigidTransform<Mri, frames::Target>>& target = {});
  ~SyntheticSource() override;

  const cameras::StereoRig& rig() const override;
  std::shared_ptr<const cameras::StereoFrame> next() override;
  std::optional<std::int64_t> frameCount() const override;

  /// Renders one picture pair of the capture, with these dots or without.
  cameras::StereoFrame captureWith(std::optional<stereo::DotPattern> dots);
  /// Renders the same moment with the coil held on its target, without dots. `again`: number of such pictures
  /// taken before; each has its own noise.
  cameras::StereoFrame captureWithCoil(int again = 0);
  /// Renders the same moment while the projector shows a picture (8-bit, 1 channel, of projector()'s size).
  cameras::StereoFrame captureShowing(const cv::Mat& picture);
  cameras::ProjectorModel projector() const;
  /// Renders the still pair for the initial alignment (dense dots), with the head's pose in it.
  capture::CapturePair capturePair();
  RigidTransform<Camera, Mri> captureTruth() const;
  /// Truth of the last frame that next() returned.
  const GroundTruth& truth() const;
  DepthMaps depth() const;
  const RoomCoil& coil() const;
  /// The second coil and its target; nothing: there is none (ScenarioOptions::coils).
  const std::optional<RoomCoil>& secondCoil() const;
  const std::optional<RigidTransform<Mri, frames::Target>>& secondTarget() const;
  const RigidTransform<Mri, frames::Target>& target() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::room
