// facenav align CASE RECORDING: the recording's images (pair with dots, plain pair, film) ->
// CASE/alignment.json (or --rig, --left, --right, -o).

#include <cmath>
#include <cstdio>
#include <opencv2/imgcodecs.hpp>

#include "commands/commands.h"
#include "commands/confirmation_option.h"
#include "commands/live_option.h"
#include "facenav/align/align_case.h"
#include "facenav/align/alignment_seen.h"
#include "facenav/pictures/titled_row.h"
#include "facenav/scene/png.h"
#include "facenav/setup/record_live.h"
#include "json_output.h"
#include "typed_values.h"
#include "wrong_usage.h"

namespace facenav::app {
namespace {

struct AlignRequest {
  std::filesystem::path case_folder;
  std::optional<std::filesystem::path> recording, rig, output, picture;
  std::vector<std::filesystem::path> left, right;  // with dots, without
  std::string aligner, matcher = stereo::kDefaultMatcher, from;
  LiveChoice live;  // only its rig
  bool is_patient_confirmed = false, is_json = false;
};

cv::Mat readGrey(const std::filesystem::path& path) {
  if (!std::filesystem::exists(path)) throw Error("file does not exist", path.string(), "check the path");
  cv::Mat image = cv::imread(path.string(), cv::IMREAD_GRAYSCALE);
  if (image.empty()) throw Error("is not an image that can be read", path.string(), "use PNG, TIFF or JPEG");
  return image;
}

void requirePictures(const AlignRequest& request) {
  if (request.recording || !request.live.rig.empty()) return;
  if (!request.rig || request.left.empty() || request.left.size() != request.right.size() ||
      request.left.size() > 2)
    throw WrongUsage("give a RECORDING, or --rig with as many --left as --right images",
                     "first the image with dots, then the one without");
}

/// Reads capture pair and rig from single files: the pair with dots, then the one without; a single pair is
/// used as both.
capture::Recording fromFiles(const AlignRequest& request) {
  capture::Recording recording;
  recording.rig = cameras::readRig(*request.rig);
  capture::CapturePair pair;
  pair.pattern.left = readGrey(request.left.front());
  pair.pattern.right = readGrey(request.right.front());
  pair.plain.left = readGrey(request.left.back());
  pair.plain.right = readGrey(request.right.back());
  for (const auto& image : {pair.pattern.left, pair.pattern.right, pair.plain.left, pair.plain.right})
    if (image.cols != recording.rig.width_px || image.rows != recording.rig.height_px)
      throw Error("image is " + std::to_string(image.cols) + " x " + std::to_string(image.rows) +
                      ", the rig's are " + std::to_string(recording.rig.width_px) + " x " +
                      std::to_string(recording.rig.height_px),
                  request.left.front().string(), "use the rig's own calibration");
  recording.capture = pair;
  return recording;
}

/// Takes pictures now: one pair with the coil's marker beside the face, or two with the projector on and off.
capture::Recording fromCameras(const AlignRequest& request, const Context& context) {
  if (request.from == "film")
    throw WrongUsage("a film is not aligned from live cameras", "record it first: facenav record --rig NAME");
  const auto source = openVerifiedRig(request.live, context);
  requireUnmoved(*source, request.live.rig);
  capture::Recording recording;
  recording.rig = source->rig();
  if (request.from == "dots") recording.capture = askForCapture(*source);
  if (request.from.empty()) recording.capture = askForCaptureIfProjector(*source);
  if (recording.capture) return recording;
  const auto still = takeMarked(*source, request.live, context);
  recording.capture = capture::CapturePair{still, still};
  return recording;
}

capture::Recording openWhatIsAligned(const AlignRequest& request, const Context& context) {
  if (!request.live.rig.empty()) return fromCameras(request, context);
  return request.recording ? capture::openCapture(*request.recording) : fromFiles(request);
}

/// Prints the parts of the face that fit worse than expected of a good skin model and a still face.
void printWorstRegions(const std::vector<registration::RegionFit>& regions) {
  constexpr double kNoted_mm = 0.5;
  std::string words;
  for (const auto& region : regions)
    if (std::abs(region.offset_mm) > kNoted_mm) words += (words.empty() ? "" : ", ") + inWords(region);
  if (!words.empty()) std::printf("skin: %s\n", words.c_str());
}

/// Draws the MRI's skin over both pictures of the capture, for a person to judge.
void writePicture(const std::filesystem::path& path, const casefile::CaseStore& store,
                  const cameras::StereoRig& rig, const steps::AlignmentOutcome& outcome) {
  auto drawn = steps::drawAlignment(rig, outcome, steps::seeAlignment(store, outcome));
  scene::writePng(pictures::titledRow({{"MRI's skin, left camera", std::move(drawn.left)},
                                       {"MRI's skin, right camera", std::move(drawn.right)}}),
                  path);
}

void printJsonOf(const std::string& words, const casefile::StoredAlignment& stored) {
  nlohmann::ordered_json targets = nlohmann::ordered_json::array();
  for (const auto& [target, error_mm] : stored.predicted_tre_mm)
    targets.push_back({{"name", target},
                       {"predicted_mm", error_mm},
                       {"predicted_95_mm", stored.predicted_tre_p95_mm.at(target)}});
  printJson({{"words", words},
             {"from", stored.from.value_or("")},
             {"rms_mm", stored.rms_mm},
             {"max_mm", stored.max_mm},
             {"points", stored.points},
             {"inlier_fraction", stored.inlier_fraction},
             {"targets", targets},
             {"cautions", stored.cautions}});
}

void runAlign(Context& context, const AlignRequest& request) {
  requirePictures(request);
  const auto store = casefile::CaseStore::open(request.case_folder);
  const auto recording = openWhatIsAligned(request, context);
  steps::AlignOrder order{request.aligner};
  order.matcher = request.matcher;
  order.tries_all = true;
  if (!request.live.coil.words.empty()) order.coil = coilOf(request.live.coil);
  order.may_be_unsure = request.live.rig.empty();
  order.is_patient_confirmed = request.is_patient_confirmed;
  if (request.live.rig.empty()) order.from = measured_face::alignedFrom(request.from);
  const auto aligned = steps::alignRecording(context.registrations, store, recording, order, context.monitor);
  const auto& outcome = aligned.outcome;
  const auto stored = outcome.stored();
  if (request.output) casefile::writeAlignment(stored, *request.output);
  if (request.picture) writePicture(*request.picture, store, recording.rig, outcome);
  if (request.is_json) return printJsonOf(inWords(aligned), stored);
  if (context.is_quiet) return;
  std::printf("%s\n", inWords(aligned).c_str());
  if (stored.matcher) std::printf("face measured by the matcher %s\n", stored.matcher->c_str());
  std::printf("aligned: residual rms %.2f mm, max %.2f mm, %d points (%.0f %% of the face)\n", stored.rms_mm,
              stored.max_mm, stored.points, 100 * stored.inlier_fraction);
  for (const auto& [target, bound_mm] : stored.predicted_tre_p95_mm)
    std::printf("at %s: 95 %% within %.1f mm\n", target.c_str(), bound_mm);
  printWorstRegions(outcome.regions);
  for (const auto& caution : stored.cautions) std::printf("caution: %s\n", caution.c_str());
}

}  // namespace

void addAlign(CLI::App& app, Context& context) {
  auto* verb = app.add_subcommand(
      "align", "what a recording holds of the face (dots, plain pair, film) -> alignment of the MRI to it");
  auto request = std::make_shared<AlignRequest>();
  request->aligner = context.registrations.aligners.defaultName();
  verb->add_option("CASE", request->case_folder, "case folder")->required();
  verb->add_option("RECORDING", request->recording,
                   "recording folder with stereo.yml and capture/ or a film");
  verb->add_option("--rig", request->rig, "stereo.yml, instead of RECORDING");
  verb->add_option(
      "--live", request->live.rig,
      "a rig by its name, instead of RECORDING: takes the pictures now, with a projector or without");
  verb->add_option("--rigs", request->live.rigs, "with --live: folder of the rigs");
  addVerifyingCoilOptions(*verb, request->live);
  verb->add_option("--left", request->left, "left image with dots, then the one without");
  verb->add_option("--right", request->right, "right image with dots, then the one without");
  verb->add_option("-o,--output", request->output, "also write alignment.json here");
  verb->add_option("--picture", request->picture,
                   "PNG: the MRI's skin (contour, points, landmarks) over both pictures, to judge by eye");
  verb->add_option("--aligner", request->aligner, "method: " + steps::namesOf(context.registrations.aligners))
      ->check(namedIn(context.registrations.aligners))
      ->capture_default_str();
  verb->add_option(
          "--using", request->from,
          "align from this alone: dots, plain (the pair without dots) or film (its first two seconds, in "
          "which the head turns to both sides); default: dots, else what predicts less error. With --live: "
          "plain takes one picture, with the coil held still beside the face")
      ->check(CLI::IsMember({"dots", "plain", "film"}));
  verb->add_option("--matcher", request->matcher,
                   "measures a face with dots by: " + stereo::denseMatcherList())
      ->check(understoodBy([](const std::string& name) { stereo::makeDenseMatcher(name); }))
      ->capture_default_str();
  addConfirmationOption(*verb, request->is_patient_confirmed);
  verb->add_flag("--json", request->is_json, "the result as JSON");
  verb->callback([&context, request] { runAlign(context, *request); });
}

}  // namespace facenav::app
