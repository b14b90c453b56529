#pragma once
// VerifiedCameras: the cameras of a kept rig, verified while they run (rig_start.h). Frames pass through at
// once; the check runs beside them on its own thread. While it finds a fault, each frame carries it
// (StereoFrame::rig_fault), so that no session and no alignment uses it.

#include <functional>
#include <memory>
#include <string>

#include "facenav/capture/camera_backend.h"
#include "facenav/capture/frame_source.h"
#include "facenav/setup/rig_start.h"

namespace facenav::steps {

class VerifiedCameras : public capture::FrameSource {
 public:
  /// Told of the first answer, and of each later one that says something else; "unclear" after some seconds
  /// in which nothing was seen, or at the end. From the check's thread or the destructor.
  using Told = std::function<void(const RigStart&)>;

  /// `repair`: what to do about a fault, added to the frames' words: "repair them with ..".
  VerifiedCameras(std::unique_ptr<capture::FrameSource> cameras, RigStartCheck check, std::string repair,
                  Told told);
  /// Waits for the frame that is being judged (a second at most).
  ~VerifiedCameras() override;

  const cameras::StereoRig& rig() const override;
  std::shared_ptr<const cameras::StereoFrame> next() override;
  std::optional<std::int64_t> frameCount() const override;
  std::vector<std::string> cautions() const override;

  /// Never null; before the first answer: unclear, with what an earlier check left in force.
  std::shared_ptr<const RigStart> standing() const;
  /// Reads frames until the face or the marker has given an answer, at most `limit_s`. Throws as next().
  void settle(double limit_s);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// Opens the rig's two cameras with its settings and verifies them. Throws as capture::openRig.
std::unique_ptr<VerifiedCameras> openVerified(const capture::CameraBackends& backends,
                                              const capture::NamedRig& rig, RigStartMethods methods,
                                              const std::string& repair, VerifiedCameras::Told told);

/// Keeps the finding with the rig, with the time. A fault that an earlier check found stays there until it is
/// cleared, and a calibration that held is not replaced by "unclear". Throws Error as RigStore::note.
void keepRigStart(const capture::RigStore& store, const std::string& name, const RigStart& found);

}  // namespace facenav::steps
