#include "commands/live_option.h"

#include <cstdio>
#include <iostream>

#include "facenav/core/error.h"
#include "facenav/core/log.h"
#include "facenav/setup/record_live.h"
#include "wrong_usage.h"

namespace facenav::app {
namespace {

constexpr double kSettleRig_s = 8.0;  // by then a visible face is measured three times

std::string repairOf(const std::string& rig) {
  const bool is_quoted = rig.find(' ') != std::string::npos;
  const std::string quote = is_quoted ? "'" : "";
  return "repair it in two minutes: facenav-gui --set-up --rig " + quote + rig + quote;
}

void tellStart(const LiveChoice& choice, const steps::RigStart& found) {
  const std::string words = "rig " + choice.rig + ": " + found.words();
  if (found.isWithheld())
    logWarning(words + "; guidance and alignment are withheld; " + repairOf(choice.rig));
  else if (!found.differs.empty() || found.state == health::RigState::unclear)
    logWarning(words);
  else
    logInfo(words);
  try {
    steps::keepRigStart(capture::RigStore(choice.rigs), choice.rig, found);
  } catch (const Error& error) {
    logWarning(error.what());
  }
}

/// Returns the answer typed on the terminal.
std::string ask(const char* words) {
  std::fprintf(stderr, "%s: ", words);
  std::string line;
  if (!std::getline(std::cin, line)) throw Error("no answer on standard input: nothing was taken");
  return line;
}

capture::CapturePair withDots(capture::FrameSource& source) {
  capture::CapturePair pair;
  pair.pattern = steps::takeStill(source);
  ask("projector off, the head still, then press Return");
  pair.plain = steps::takeStill(source);
  return pair;
}

}  // namespace

void addLiveOptions(CLI::App& verb, LiveChoice& choice) {
  auto* rig = verb.add_option("--rig", choice.rig, "live cameras: a rig by its name, see 'facenav rig list'");
  verb.add_option("--rigs", choice.rigs, "folder of the rigs (default: the user's configuration)");
  auto* left = verb.add_option("--left", choice.left,
                               "or two cameras: name or address from 'facenav cameras', a stream or a video");
  auto* right = verb.add_option("--right", choice.right, "likewise");
  auto* calibration =
      verb.add_option("--calibration", choice.calibration, "with --left and --right: their stereo.yml");
  left->needs(right)->needs(calibration)->excludes(rig);
  right->needs(left)->excludes(rig);
  verb.add_option("--rate", choice.settings.frames_per_s, "with --left and --right: pictures a second")
      ->capture_default_str()
      ->check(CLI::Range(1.0, 1000.0));
}

void addVerifyingCoilOptions(CLI::App& verb, LiveChoice& choice) {
  verb.add_option("--coil", choice.coil.words,
                  "with a rig: the coil in view, by name or its coil.json; its marker verifies the cameras");
  addCoilLibraryOption(verb, choice.coil.library);
}

std::unique_ptr<steps::VerifiedCameras> openVerifiedRig(const LiveChoice& choice, const Context& context) {
  const auto& methods = context.registrations;
  const auto rig = capture::RigStore(choice.rigs).read(choice.rig);
  steps::RigStartMethods judges{methods.face_detector(),
                                methods.coil_trackers.create(methods.coil_trackers.defaultName()),
                                coilOf(choice.coil)};
  return steps::openVerified(methods.cameras, rig, std::move(judges), repairOf(choice.rig),
                             [choice](const steps::RigStart& found) { tellStart(choice, found); });
}

void requireUnmoved(steps::VerifiedCameras& cameras, const std::string& rig) {
  cameras.settle(kSettleRig_s);
  const auto found = cameras.standing();
  if (found->isWithheld()) throw Error("not aligned: " + found->words(), rig, repairOf(rig));
}

std::unique_ptr<capture::FrameSource> openLive(const LiveChoice& choice, const Context& context) {
  if (!choice.rig.empty()) return openVerifiedRig(choice, context);
  if (choice.left.empty())
    throw WrongUsage("it is not said which cameras",
                     "give --rig NAME, or --left, --right and --calibration stereo.yml");
  const auto& backends = context.registrations.cameras;
  const auto rig = cameras::readRig(choice.calibration);
  const auto found = capture::listCameras(backends);
  auto left = capture::openCamera(backends, capture::findCamera(found, choice.left));
  auto right = capture::openCamera(backends, capture::findCamera(found, choice.right));
  auto source =
      capture::openCameraPair(rig, std::move(left), std::move(right), {choice.settings, choice.settings});
  for (const auto& words : capture::changedSettings(*source)) logWarning(words);
  return source;
}

capture::CapturePair askForCapture(capture::FrameSource& source) {
  ask("projector on, the head still, then press Return");
  return withDots(source);
}

std::optional<capture::CapturePair> askForCaptureIfProjector(capture::FrameSource& source) {
  if (ask("projector on, the head still, then press Return (n and Return: there is no projector)") == "n")
    return std::nullopt;
  return withDots(source);
}

cameras::StereoFrame takeMarked(capture::FrameSource& source, const LiveChoice& choice,
                                const Context& context) {
  constexpr double kLimit_s = 30;
  const auto& methods = context.registrations;
  steps::AutomaticCapture still(
      source.rig(), {methods.face_detector(),
                     methods.coil_trackers.create(methods.coil_trackers.defaultName()), coilOf(choice.coil)});
  if (!context.is_quiet)
    std::fprintf(stderr, "look at the cameras; %s; the picture is taken by itself\n", still.words().c_str());
  steps::takeStillCapture(source, still, kLimit_s, context.monitor);
  return still.still();
}

}  // namespace facenav::app
