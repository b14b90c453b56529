// facenav calibrate: pairs of a chessboard or ChArUco board -> stereo.yml, with the figures by which to judge
// it.

#include <cstdio>
#include <ctime>
#include <memory>

#include "commands/commands.h"
#include "facenav/cameras/calibrate.h"
#include "facenav/cameras/rig_file.h"
#include "facenav/capture/calibration_images.h"
#include "facenav/core/log.h"
#include "facenav/core/number_text.h"
#include "facenav/geometry/rotation.h"
#include "json_output.h"

namespace facenav::app {
namespace {

struct Arguments {
  std::string board;
  double square_mm = 0;
  std::optional<double> marker_mm;
  std::string dictionary = cameras::Board{}.dictionary;
  std::vector<std::string> left, right;
  std::string output = "stereo.yml";
  bool is_json = false;
};

std::string utcNow() {
  const std::time_t now = std::time(nullptr);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", std::gmtime(&now));
  return text;
}

std::string figure(const std::optional<double>& px) { return px ? formatted("%.3f", *px) : "-"; }

void printViews(const cameras::Calibration& result) {
  std::printf("%-32s %8s %8s\n", "view", "left px", "right px");
  for (const auto& view : result.views) {
    const char* state = view.is_used ? "" : "not used: ";
    std::printf("%-32s %8s %8s  %s%s\n", view.name.c_str(), figure(view.left_rms_px).c_str(),
                figure(view.right_rms_px).c_str(), state, view.reason.c_str());
  }
}

void printRig(const cameras::Calibration& result) {
  const cameras::StereoRig& rig = result.rig;
  for (const auto& model : result.models)
    std::printf("distortion %-24s rms %.4f px, on views left out %.4f px%s\n", model.name.c_str(),
                model.rms_px, model.held_out_rms_px, model.name == result.model ? "  <- taken" : "");
  for (const auto& [side, camera] : {std::pair("left", &rig.left), std::pair("right", &rig.right)})
    std::printf("%-5s f %.2f %.2f px, centre %.2f %.2f px\n", side, camera->k(0, 0), camera->k(1, 1),
                camera->k(0, 2), camera->k(1, 2));
  const double angle_deg = rotationAngle(rig.right_T_left.rotation()) * kDegPerRad;
  for (const auto& parameter : result.parameters)
    std::printf("  %-14s %12.6g +- %.2g\n", parameter.name.c_str(), parameter.value, parameter.sigma);
  std::printf("baseline %.3f mm, angle between the cameras %.3f deg\n", rig.baseline_mm(), angle_deg);
  const cameras::HeadEffect& head = result.at_head;
  std::printf(
      "effect at the head (%.0f mm away, 1 sigma): a point %.2f mm (%.2f mm of it in distance), a length of "
      "100 mm %.2f mm, a motion of 20 mm and 5 deg %.2f mm and %.3f deg\n",
      head.distance_mm, head.point_mm, head.depth_mm, head.length_mm, head.motion_mm, head.motion_deg);
}

void run(const Arguments& arguments, Context& context) {
  cameras::Board board = cameras::boardFromText(arguments.board, arguments.square_mm, arguments.marker_mm);
  board.dictionary = arguments.dictionary;
  const auto pairs = capture::readCalibrationImages(arguments.left, arguments.right);
  const cameras::Calibration result = cameras::calibrate(pairs, board, context.monitor);
  char board_text[96];
  std::snprintf(board_text, sizeof board_text, "%s, %g mm", arguments.board.c_str(), board.square_mm);
  cameras::writeRig(result.rig, arguments.output, {board_text, result.usedViews(), utcNow(), result.at_head});
  for (const auto& warning : result.warnings) logWarning(warning);
  if (arguments.is_json)
    return printJson({{"rms_px", result.rms_px},
                      {"held_out_rms_px", result.held_out_rms_px},
                      {"used_views", result.usedViews()},
                      {"views", result.views.size()},
                      {"warnings", result.warnings},
                      {"output", arguments.output}});
  if (!context.is_quiet) {
    printViews(result);
    printRig(result);
  }
  std::printf(
      "stereo rms %.4f px (all corners of %d of %zu views, left and right), on views left out %.4f px: %s\n",
      result.rms_px, result.usedViews(), result.views.size(), result.held_out_rms_px,
      arguments.output.c_str());
}

}  // namespace

void addCalibrate(CLI::App& app, Context& context) {
  CLI::App* verb = app.add_subcommand("calibrate", "pairs of a chessboard or ChArUco board -> stereo.yml");
  const auto arguments = std::make_shared<Arguments>();
  verb->add_option("--board", arguments->board,
                   "inner corners of the chessboard, 9x6, or squares of a ChArUco board, charuco:7x5")
      ->required();
  verb->add_option("--square", arguments->square_mm, "side of one square, mm")->required();
  verb->add_option("--marker", arguments->marker_mm, "ChArUco: side of one marker, mm (0.75 squares)");
  verb->add_option("--dictionary", arguments->dictionary, "ChArUco: of its markers")->capture_default_str();
  verb->add_option("--left", arguments->left, "left images: files or a quoted pattern, 'left*.jpg'")
      ->required();
  verb->add_option("--right", arguments->right, "right images, in the same way")->required();
  verb->add_option("-o,--output", arguments->output, "where the rig is written")->capture_default_str();
  verb->add_flag("--json", arguments->is_json, "the result as JSON");
  verb->callback([arguments, &context] { run(*arguments, context); });
}

}  // namespace facenav::app
