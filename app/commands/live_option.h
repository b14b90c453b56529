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
  capture::CameraSettings settings;         // for --left and --right; a rig has its own
  CoilChoice coil;                          // the coil whose marker verifies a rig; empty: the default coil
  double frames_per_s() const { return settings.frames_per_s; }
};

/// Adds --rig, --rigs, --left, --right, --calibration, --rate.
void addLiveOptions(CLI::App& verb, LiveChoice& choice);
/// Adds --coil and --coils to a verb that has no other use for a coil.
void addVerifyingCoilOptions(CLI::App& verb, LiveChoice& choice);
/// Opens both cameras. Warns of adjustments that are not locked. A rig is verified while it runs
/// (openVerifiedRig). Throws Error if no cameras are given; CameraError as capture::openRig does.
std::unique_ptr<capture::FrameSource> openLive(const LiveChoice& choice, const Context& context);
/// Opens the cameras of choice.rig. The result of the verification is reported in one line and stored with
/// the rig; frames of moved cameras carry their fault (StereoFrame::rig_fault). Throws as openLive.
std::unique_ptr<steps::VerifiedCameras> openVerifiedRig(const LiveChoice& choice, const Context& context);
/// Waits some seconds for the first result. Throws Error with the repair if the rig has moved.
void requireUnmoved(steps::VerifiedCameras& cameras, const std::string& rig);
/// Asks on the terminal for the projector on, then off, and takes a pair each time. Throws Error if standard
/// input has ended.
capture::CapturePair askForCapture(capture::FrameSource& source);
/// Like askForCapture, but returns nothing if the user answers that there is no projector.
std::optional<capture::CapturePair> askForCaptureIfProjector(capture::FrameSource& source);
/// Waits until both cameras see the face and, at rest, the coil's marker (automatic_capture.h), for half a
/// minute at most. Throws Error.
cameras::StereoFrame takeMarked(capture::FrameSource& source, const LiveChoice& choice,
                                const Context& context);

}  // namespace facenav::app
