// facenav cameras: lists the connected cameras, what to do before two of them can be used, and tries a pair.

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "commands/camera_latency.h"
#include "commands/camera_print.h"
#include "commands/commands.h"
#include "commands/picture_size.h"
#include "facenav/capture/camera_backend.h"
#include "facenav/capture/camera_pair_source.h"
#include "idle_options.h"
#include "wrong_usage.h"

namespace facenav::app {
namespace {

using Json = nlohmann::ordered_json;

struct CamerasRequest {
  std::string left, right, size = "640x480";
  double try_s = 0.0, frames_per_s = 30.0;
  bool is_json = false, is_quick = false, has_latency = false;
};

Json toJson(const capture::FoundCamera& camera) {
  static const char* const kUses[] = {"free", "in_use", "no_permission", "no_answer"};
  const auto& identity = camera.identity;
  return {{"name", capture::stableName(identity)},
          {"connection", identity.backend},
          {"address", identity.address},
          {"model", identity.model},
          {"serial", identity.serial},
          {"port", identity.port},
          {"use", kUses[int(camera.use)]},
          {"used_by", camera.user}};
}

void printList(const std::vector<capture::FoundCamera>& found, bool is_json) {
  const auto advice = capture::adviceOn(found);
  if (is_json) {
    Json list = Json::array();
    for (const auto& camera : found) list.push_back(toJson(camera));
    std::printf("%s\n", Json{{"cameras", list}, {"advice", advice}}
                            .dump(1, ' ', false, Json::error_handler_t::replace)
                            .c_str());
    return;
  }
  for (const auto& camera : found)
    std::printf("%-40s %s\n", capture::stableName(camera.identity).c_str(), capture::inWords(camera).c_str());
  for (const auto& words : advice) std::printf("%s\n", words.c_str());
}

void tryPair(const capture::CameraBackends& backends, const std::vector<capture::FoundCamera>& found,
             const CamerasRequest& request) {
  const auto open = [&](const std::string& name) {
    return capture::openCamera(backends, capture::findCamera(found, name));
  };
  capture::PairSettings settings;
  settings.left.frames_per_s = settings.right.frames_per_s = request.frames_per_s;
  const auto source =
      capture::openCameraPair(sizeOnly(request.size), open(request.left), open(request.right), settings);
  const double begun_s = Timestamp::now().s;
  double latest_s = 0;
  int frames = 0;
  for (; Timestamp::now().s < begun_s + request.try_s; ++frames) {
    const auto frame = source->next();
    if (!frame) break;
    latest_s = std::max(latest_s, Timestamp::now() - frame->captured);
  }
  const double rate = frames / (Timestamp::now().s - begun_s);
  if (request.is_json)
    std::printf("%s\n", trialJson(*source, rate, latest_s).c_str());
  else
    printTrial(*source, rate, latest_s);
}

}  // namespace

void addCameras(CLI::App& app, Context& context) {
  auto* verb =
      app.add_subcommand("cameras", "the connected cameras, what to do about them, and a trial of a pair");
  auto request = std::make_shared<CamerasRequest>();
  verb->add_flag("--json", request->is_json, "as JSON");
  verb->add_flag("--quick", request->is_quick, "do not ask the network for GigE cameras");
  verb->add_option(
          "--try", request->try_s,
          "s: open --left and --right for so long; show rate, delay between them, locked adjustments")
      ->check(CLI::Range(0.1, 3600.0));
  verb->add_flag("--latency", request->has_latency,
                 "the terminal flashes and the camera --left films it: time from the camera to the screen");
  verb->add_option("--left", request->left,
                   "camera: name or address from this list, or the address of a stream");
  verb->add_option("--right", request->right, "likewise");
  verb->add_option("--size", request->size, "of the pictures, px")->capture_default_str();
  verb->add_option("--rate", request->frames_per_s, "pictures a second")
      ->capture_default_str()
      ->check(CLI::Range(1.0, 1000.0));
  verb->callback([request, &context, verb] {
    refuseIdle(*verb, {"--left", "--right", "--size", "--rate"}, {"--try", "--latency"});
    if (request->has_latency && request->left.empty())
      throw WrongUsage("--latency needs a camera", "give it with --left");
    if (request->try_s > 0 && (request->left.empty() || request->right.empty()))
      throw WrongUsage("--try needs two cameras",
                       "give --left and --right with names or addresses from 'facenav cameras'");
    const auto size = sizeOnly(request->size);
    const auto& backends = context.registrations.cameras;
    const auto found = capture::listCameras(
        backends, request->is_quick ? capture::Search::quick : capture::Search::everywhere);
    if (request->has_latency) {
      capture::CameraSettings settings;
      settings.width_px = size.width_px;
      settings.height_px = size.height_px;
      settings.frames_per_s = request->frames_per_s;
      return measureLatency(backends, capture::findCamera(found, request->left), settings, request->is_json);
    }
    if (request->try_s > 0) return tryPair(backends, found, *request);
    printList(found, request->is_json);
  });
}

}  // namespace facenav::app
