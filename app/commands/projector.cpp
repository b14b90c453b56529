// facenav projector pictures|calibrate: the projector's own calibration by the calibrated cameras.

#include <cstdio>
#include <opencv2/imgcodecs.hpp>

#include "commands/commands.h"
#include "commands/picture_size.h"
#include "facenav/capture/recording.h"
#include "facenav/core/error.h"
#include "facenav/core/log.h"
#include "facenav/core/number_text.h"
#include "facenav/core/whole_folder.h"
#include "facenav/stereo/projector_calibration.h"
#include "typed_values.h"

namespace facenav::app {
namespace {

struct ProjectorRequest {
  std::string size = "1024x768";
  std::vector<std::filesystem::path> scenes;
  std::filesystem::path output;
};

stereo::ProjectorCode codeOf(const ProjectorRequest& request) {
  const auto size = sizeOnly(request.size);
  return {size.width_px, size.height_px, stereo::ProjectorCode().period_px};
}

void writePictures(const ProjectorRequest& request, bool is_quiet) {
  const auto pictures = stereo::codePictures(codeOf(request));
  WholeFolder folder(request.output, FileAccess::by_umask);
  for (std::size_t i = 0; i < pictures.size(); ++i)
    if (!cv::imwrite((folder.temporaryPath() / formatted("%02zu.png", i)).string(), pictures[i]))
      throw Error("image cannot be written", request.output.string(), "check free disk space");
  folder.commit();
  if (!is_quiet)
    std::printf(
        "%s: %zu pictures; show each on the projector, pixel by pixel, and take one pair of each in this "
        "order "
        "as a recording\n",
        request.output.c_str(), pictures.size());
}

/// Adds the points of one scene: a recording with one pair for each picture of the code.
void addScene(const std::filesystem::path& scene, const stereo::ProjectorCode& code,
              std::vector<stereo::LitPlace>& places) {
  const auto recording = capture::openRecording(scene);
  const auto source = capture::makeSource(recording);
  std::vector<cv::Mat> left, right;
  while (const auto frame = source->next()) {
    left.push_back(frame->left);
    right.push_back(frame->right);
  }
  const auto left_seen = stereo::decode(left, code), right_seen = stereo::decode(right, code);
  for (const auto& [side, seen] : {std::pair("left", &left_seen), std::pair("right", &right_seen)})
    for (const auto& words : seen->advice()) logWarning(scene.string() + ", " + side + " camera: " + words);
  const auto found = stereo::matchCodes(recording.rig, left_seen, right_seen);
  places.insert(places.end(), found.begin(), found.end());
}

void calibrateFromScenes(const ProjectorRequest& request, Context& context) {
  const auto code = codeOf(request);
  std::vector<stereo::LitPlace> places;
  for (std::size_t i = 0; i < request.scenes.size(); ++i) {
    context.monitor.report("decoding", double(i) / double(request.scenes.size()));
    addScene(request.scenes[i], code, places);
  }
  const auto result = stereo::calibrateProjector(places, code);
  cameras::writeProjector(result.projector, request.output);
  if (context.is_quiet) return;
  std::printf(
      "%s: %d places from %.0f to %.0f mm (%d outliers left out); reprojection error %.3f px rms, %.3f px "
      "(median) on places left out\n",
      request.output.c_str(), result.places, result.nearest_mm, result.farthest_mm, result.left_out,
      result.rms_px, result.held_out_px);
}

}  // namespace

void addProjector(CLI::App& app, Context& context) {
  auto* projector = app.add_subcommand("projector", "the projector's calibration: pictures, calibrate");
  projector->require_subcommand(1);
  const auto request = std::make_shared<ProjectorRequest>();
  auto* pictures = projector->add_subcommand(
      "pictures", "pictures (Gray code, phase shift) that tell which projector pixel lights a place");
  auto* calibrate =
      projector->add_subcommand("calibrate", "the cameras' pictures of them -> projector.yml (for guide)");
  for (auto* verb : {pictures, calibrate})
    verb->add_option("--size", request->size, "of the projector's picture, px")->capture_default_str();
  pictures->add_option("-o,--output", request->output, "folder to write")->required()->check(folderToMake());
  calibrate
      ->add_option(
          "SCENE", request->scenes,
          "recordings with the rig's stereo.yml and one pair for each picture, in order: a face or a "
          "wall with depth, or a plane at two distances")
      ->required();
  calibrate->add_option("-o,--output", request->output, "projector.yml to write")->required();
  pictures->callback([request, &context] { writePictures(*request, context.is_quiet); });
  calibrate->callback([request, &context] { calibrateFromScenes(*request, context); });
}

}  // namespace facenav::app
