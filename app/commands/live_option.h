#pragma once
// Live cameras given on the command line: a rig by its name, or two cameras and their calibration.

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <string>

#include "context.h"
#include "facenav/capture/recording.h"
#include "facenav/capture/rig_store.h"

namespace facenav::app {

struct LiveChoice {
  std::string rig, left, right;             // names
  std::filesystem::path rigs, calibration;  // rigs: empty: the usual folder
  capture::CameraSettings settings;         // of --left and --right; a rig has its own
  double frames_per_s() const { return settings.frames_per_s; }
};

/// --rig, --rigs, --left, --right, --calibration, --rate.
void addLiveOptions(CLI::App& verb, LiveChoice& choice);
/// Opens both cameras. Warns of adjustments that are not locked and of a rig whose last check failed. Throws
/// Error: it is not said which cameras; CameraError as capture::openRig does.
std::unique_ptr<capture::CameraPairSource> openLive(const LiveChoice& choice, const Context& context);
/// Asks on the terminal for the projector on, then off, and takes a pair each time. Throws Error: standard
/// input has ended.
capture::CapturePair askForCapture(capture::FrameSource& source);

}  // namespace facenav::app
