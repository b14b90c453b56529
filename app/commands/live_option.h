#pragma once
// Live cameras given on the command line: a rig by its name, or two cameras and their calibration.

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "commands/coil_option.h"
#include "context.h"
#include "facenav/align/automatic_capture.h"
#include "facenav/capture/recording.h"
#include "facenav/setup/verified_cameras.h"

namespace facenav::app {

struct LiveChoice {
  std::string rig, left, right;             // names
  std::filesystem::path rigs, calibration;  // rigs: empty: the usual folder
  capture::CameraSettings settings;         // of --left and --right; a rig has its own
  CoilChoice coil;                          // whose marker verifies a rig; none: the default coil
  double frames_per_s() const { return settings.frames_per_s; }
};

/// --rig, --rigs, --left, --right, --calibration, --rate.
void addLiveOptions(CLI::App& verb, LiveChoice& choice);
/// --coil, --coils, of a verb that has no other use for a coil.
void addVerifyingCoilOptions(CLI::App& verb, LiveChoice& choice);
/// Opens both cameras. Warns of adjustments that are not locked. A rig is verified while it runs
/// (openVerifiedRig). Throws Error: it is not said which cameras; CameraError as capture::openRig does.
std::unique_ptr<capture::FrameSource> openLive(const LiveChoice& choice, const Context& context);
/// The cameras of choice.rig. What is found is said in one line and kept with the rig; frames of cameras that
/// have moved carry their fault (StereoFrame::rig_fault). Throws as openLive.
std::unique_ptr<steps::VerifiedCameras> openVerifiedRig(const LiveChoice& choice, const Context& context);
/// Waits for the first answer, some seconds. Throws Error: the rig has moved, and how it is repaired.
void requireUnmoved(steps::VerifiedCameras& cameras, const std::string& rig);
/// Asks on the terminal for the projector on, then off, and takes a pair each time. Throws Error: standard
/// input has ended.
capture::CapturePair askForCapture(capture::FrameSource& source);
/// The same where there may be no projector: nothing where the user says so.
std::optional<capture::CapturePair> askForCaptureIfProjector(capture::FrameSource& source);
/// Waits until both cameras see the face and, at rest, the coil's marker (automatic_capture.h), half a minute
/// at most. Throws Error.
cameras::StereoFrame takeMarked(capture::FrameSource& source, const LiveChoice& choice,
                                const Context& context);

}  // namespace facenav::app
