#pragma once
// SyntheticSource: a scenario as a live FrameSource: each frame is rendered when it is asked for, with its
// truth.

#include <memory>
#include <optional>

#include "facenav/capture/frame_source.h"
#include "facenav/capture/recording.h"
#include "facenav/room/ground_truth.h"
#include "facenav/room/room_coil.h"
#include "facenav/room/scenario.h"

namespace facenav::room {

class SyntheticSource : public capture::FrameSource {
 public:
  /// `target`: where `treatment` brings the coil; by default over the left hand area. Throws Error for an
  /// unknown scenario, listing those there are.
  SyntheticSource(const ScenarioOptions& options, std::shared_ptr<const VirtualPatient> patient,
                  const std::optional<RigidTransform<Mri, frames::Target>>& target = {});
  ~SyntheticSource() override;

  const cameras::StereoRig& rig() const override;
  std::shared_ptr<const cameras::StereoFrame> next() override;
  std::optional<std::int64_t> frameCount() const override;

  /// The still pair of the initial alignment, and the head's pose in it.
  capture::CapturePair capturePair();
  RigidTransform<Camera, Mri> captureTruth() const;
  /// Truth of the frame that next() gave last.
  const GroundTruth& truth() const;
  DepthMaps depth() const;
  const RoomCoil& coil() const;
  const RigidTransform<Mri, frames::Target>& target() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::room
