#include "commands/live_option.h"

#include "facenav/core/error.h"
#include "facenav/core/log.h"

namespace facenav::app {
namespace {

std::unique_ptr<capture::CameraPairSource> openNamed(const LiveChoice& choice, const Context& context) {
  const auto rig = capture::RigStore(choice.rigs).read(choice.rig);
  auto source = capture::openRig(context.registrations.cameras, rig);
  // Not before: a camera that is away is tried again several times a second.
  if (rig.last_check && rig.last_check->state != "holds")
    logWarning("the rig's last check says: " + rig.last_check->words);
  for (const auto& words : capture::changedSettings(*source)) logWarning(words);
  return source;
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

std::unique_ptr<capture::CameraPairSource> openLive(const LiveChoice& choice, const Context& context) {
  if (!choice.rig.empty()) return openNamed(choice, context);
  if (choice.left.empty())
    throw Error("it is not said which cameras", "",
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

}  // namespace facenav::app
