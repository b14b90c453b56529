// facenav rig new|check|list: camera pairs stored under a name, with locked settings and calibration, and
// checked again.

#include <cstdio>
#include <ctime>
#include <memory>

#include "commands/commands.h"
#include "commands/rig_steps.h"
#include "facenav/cameras/board_page.h"
#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "wrong_usage.h"

namespace facenav::app {

std::string rigUtcNow() {
  const std::time_t now = std::time(nullptr);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", std::gmtime(&now));
  return text;
}

std::optional<cameras::Board> boardOf(const RigRequest& request) {
  if (request.board.empty()) return std::nullopt;
  if (!(request.square_mm > 0))
    throw WrongUsage("the size of the board's squares is missing",
                     "measure a square and give it in mm: --square 25");
  return cameras::boardFromText(request.board, request.square_mm);
}

std::string uncertaintyInWords(const capture::NamedRig& rig) {
  if (!rig.uncertainty) return "uncertainty unknown: its stereo.yml has no covariance";
  return formatted("+-%.2f mm at %.0f mm", rig.uncertainty->point_mm, rig.uncertainty->distance_mm);
}

namespace {

void addBoardOptions(CLI::App& verb, RigRequest& request) {
  verb.add_option("--board", request.board, "board: 9x6 inner corners, or charuco:7x5 squares");
  verb.add_option("--square", request.square_mm, "side of one square, mm");
  verb.add_option("--left", request.left,
                  "left pictures of the board: files or a quoted pattern, 'left*.png'");
  verb.add_option("--right", request.right, "right pictures, in the same way");
}

void addNew(CLI::App& rig, const std::shared_ptr<RigRequest>& request, Context& context) {
  auto* verb = rig.add_subcommand(
      "new", "keeps two cameras, their locked settings and their calibration under a name");
  verb->add_option("NAME", request->name, "of the rig")->required();
  verb->add_option("--rigs", request->rigs, "folder of the rigs (default: the user's configuration)");
  verb->add_option("--calibration", request->calibration, "stereo.yml; or calibrate here, from pictures:");
  addBoardOptions(*verb, *request);
  verb->add_flag("--choose", request->is_choosing,
                 "of many pictures, take those that are sharp, well lit and show something new");
  verb->add_option("--size", request->size,
                   "with --board and two cameras, without pictures: calibrates live, in this size; views are "
                   "taken when the board stands still")
      ->capture_default_str();
  verb->add_option("--within", request->within_s, "s: ends the search for views")
      ->capture_default_str()
      ->check(CLI::Range(5.0, 3600.0));
  verb->add_option("--left-camera", request->left_camera, "name or address, see 'facenav cameras'");
  verb->add_option("--right-camera", request->right_camera, "likewise");
  verb->add_option("--rate", request->settings.frames_per_s, "pictures a second")
      ->capture_default_str()
      ->check(CLI::Range(1.0, 1000.0));
  verb->add_option("--format", request->settings.format,
                   "GREY, YUYV or MJPG; default: the best that is fast enough");
  verb->add_option("--exposure-ms", request->settings.exposure_ms,
                   "default: as the camera has it now; likewise:");
  verb->add_option("--gain", request->settings.gain, "in the camera's steps");
  verb->add_option("--focus", request->settings.focus, "in the camera's steps");
  verb->add_option("--white-balance-k", request->settings.white_balance_k, "colour temperature");
  verb->add_option("--distance", request->distance_mm,
                   "mm from the left camera to the target, for the stated uncertainty")
      ->capture_default_str()
      ->check(CLI::Range(100.0, 5000.0));
  verb->add_flag("--replace", request->is_replacing, "replaces a rig of this name");
  verb->callback([request, &context] { makeRig(*request, context); });
}

void addCheckOf(CLI::App& rig, const std::shared_ptr<RigRequest>& request, Context& context) {
  auto* verb = rig.add_subcommand(
      "check", "does the calibration still hold? From a board in a new position, or the coil's marker");
  verb->add_option("NAME", request->name, "of the rig")->required();
  verb->add_option("RECORDING", request->recording, "recording that shows the board or the coil's marker");
  verb->add_option("--rigs", request->rigs, "folder of the rigs (default: the user's configuration)");
  addBoardOptions(*verb, *request);
  verb->add_option("--live", request->live_s, "s: look through the rig's own cameras for so long")
      ->check(CLI::Range(0.2, 600.0));
  verb->add_option("--coil", request->coil, "coil.json with the marker; default: 60 mm, 4x4_50, id 7");
  verb->add_flag("--json", request->is_json, "as JSON");
  verb->callback([request, &context] { checkRig(*request, context); });
}

void addPage(CLI::App& rig, const std::shared_ptr<RigRequest>& request, const Context& context) {
  auto* verb = rig.add_subcommand("board", "a page with the chessboard at true size, to print (SVG, A4)");
  verb->add_option("--board", request->board, "inner corners: 9x6")->default_str("9x6");
  verb->add_option("--square", request->square_mm, "side of one square, mm")->default_str("25");
  verb->add_option("-o,--output", request->page, "SVG to write")->required();
  verb->callback([request, &context] {
    const std::string corners = request->board.empty() ? "9x6" : request->board;
    const double square_mm = request->square_mm > 0 ? request->square_mm : 25.0;
    cameras::writeBoardPage(cameras::boardFromText(corners, square_mm), request->page);
    if (!context.is_quiet)
      std::printf("%s: print at 100 %%, then measure the 100 mm line\n", request->page.c_str());
  });
}

}  // namespace

void addRig(CLI::App& app, Context& context) {
  auto* rig = app.add_subcommand("rig", "camera pairs kept under a name: new, check, list; a board to print");
  rig->require_subcommand(1);
  const auto request = std::make_shared<RigRequest>();
  addNew(*rig, request, context);
  addCheckOf(*rig, request, context);
  addPage(*rig, request, context);
  auto* list = rig->add_subcommand("list", "the rigs: cameras, size, date, uncertainty, last check");
  list->add_option("--rigs", request->rigs, "folder of the rigs (default: the user's configuration)");
  list->add_flag("--json", request->is_json, "as JSON");
  list->callback([request] { listRigs(*request); });
}

}  // namespace facenav::app
