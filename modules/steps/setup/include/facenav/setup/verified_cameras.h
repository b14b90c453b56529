#pragma once
// VerifiedCameras: the cameras of a stored rig, verified while they run (rig_start.h). Frames pass through at
// once; the check runs in parallel on its own thread. While it finds a fault, each frame carries that
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
  /// Callback for the first result and each later one that differs; "unclear" after some seconds without an
  /// observation, or at the end. Called from the check's thread or the destructor.
  using Told = std::function<void(const RigStart&)>;

  /// Starts the check. `repair`: advice on a fault, added to the frames' words: "repair them with ..".
  VerifiedCameras(std::unique_ptr<capture::FrameSource> cameras, RigStartCheck check, std::string repair,
                  Told told);
  /// Waits for the frame that is being judged (a second at most).
  ~VerifiedCameras() override;

  const cameras::StereoRig& rig() const override;
  std::shared_ptr<const cameras::StereoFrame> next() override;
  std::optional<std::int64_t> frameCount() const override;
  bool isFromFiles() const override;
  std::string missingPairs() const override;
  std::vector<std::string> cautions() const override;

  /// Latest result, never null; before the first one: unclear, with an earlier fault still in force.
  std::shared_ptr<const RigStart> standing() const;
  /// Reads frames until face or marker has given a result, at most `limit_s`. Throws as next().
  void settle(double limit_s);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// Opens the rig's two cameras with its settings and verifies them. Throws as capture::openRig.
std::unique_ptr<VerifiedCameras> openVerified(const capture::CameraBackends& backends,
                                              const capture::NamedRig& rig, RigStartMethods methods,
                                              const std::string& repair, VerifiedCameras::Told told);

/// Stores the finding with the rig and the time. A fault found by an earlier check stays until it is cleared,
/// and "unclear" does not replace a valid calibration. Throws Error as RigStore::note.
void keepRigStart(const capture::RigStore& store, const std::string& name, const RigStart& found);

}  // namespace facenav::steps
