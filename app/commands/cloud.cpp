// facenav cloud RECORDING [--frame N | --frames N..M | --plain] -o face.ply: the face measured by the
// cameras.

#include <charconv>
#include <cstdio>
#include <memory>
#include <opencv2/core.hpp>

#include "commands/commands.h"
#include "facenav/capture/colour_picture.h"
#include "facenav/core/error.h"
#include "facenav/core/log.h"
#include "facenav/core/whole_file.h"
#include "facenav/measured_face/measured_face.h"
#include "facenav/measured_face/projected_dots.h"
#include "facenav/stereo/cloud_file.h"

namespace facenav::app {
namespace {

struct CloudRequest {
  std::filesystem::path recording, output;
  std::optional<std::int64_t> frame;
  std::string frames;  // "N..M"
  bool is_plain = false;
};

struct Measurement {
  measured_face::MeasuredFace face;
  cv::Mat colour;    // empty: grey
  std::string what;  // description of the measurement
};

std::optional<std::pair<std::int64_t, std::int64_t>> rangeIn(const std::string& text) {
  const auto dots = text.find("..");
  if (dots == std::string::npos) return std::nullopt;
  std::int64_t first = 0, last = 0;
  const char *begin = text.data(), *middle = begin + dots, *end = begin + text.size();
  const auto a = std::from_chars(begin, middle, first), b = std::from_chars(middle + 2, end, last);
  const bool is_whole = a.ec == std::errc() && a.ptr == middle && b.ec == std::errc() && b.ptr == end;
  if (!is_whole || last < first) return std::nullopt;
  return std::pair(first, last);
}

std::string checkRange(const std::string& text) {
  return rangeIn(text) ? "" : "'" + text + "' is no range of frames: give N..M, 0..20 say";
}

Measurement ofFilm(Context& context, const CloudRequest& request) {
  const auto recording = capture::openRecording(request.recording);
  const auto [first, last] = *rangeIn(request.frames);
  const auto source = capture::makeSource(recording);
  const auto detector = context.registrations.face_detector();
  const auto tracker = context.registrations.head_trackers.create("model");
  Measurement result{measured_face::measureFilm(*source, first, last,
                                                head_tracking::motionSinceFirst(*tracker, source->rig()),
                                                *detector, context.monitor),
                     capture::leftColour(recording, first), ""};
  result.what = "frames " + request.frames + " (" + std::to_string(result.face.fused) + " fused, " +
                std::to_string(result.face.lost) + " lost)";
  return result;
}

/// Measures one frame of the film; without a number, the first.
Measurement ofFrame(Context& context, const capture::Recording& recording,
                    std::optional<std::int64_t> number) {
  const auto source = capture::makeSource(recording);
  auto frame = source->next();
  while (frame && number && frame->number != *number) frame = source->next();
  if (!frame && number)
    throw Error("has no frame " + std::to_string(*number), recording.folder.string(),
                "it has " + std::to_string(recording.frame_count) + " frames");
  if (!frame)
    throw Error("has neither a capture/ pair nor frames", recording.folder.string(), "record one first");
  const auto detector = context.registrations.face_detector();
  return {measured_face::measurePair(recording.rig, *frame, *frame, false, *detector, context.monitor),
          capture::leftColour(recording, frame->number),
          number ? "frame " + std::to_string(*number) : "the film's first frame"};
}

Measurement ofCapture(Context& context, const capture::Recording& recording, bool is_plain) {
  const capture::CapturePair& pair = *recording.capture;
  const bool has_dots = !is_plain && measured_face::showsDots(pair);
  if (!is_plain && !has_dots) logWarning("capture/ shows no dots: its plain pair is measured, as plain skin");
  const auto detector = context.registrations.face_detector();
  return {measured_face::measurePair(recording.rig, has_dots ? pair.pattern : pair.plain, pair.plain,
                                     has_dots, *detector, context.monitor),
          capture::captureColour(recording), has_dots ? "the pair with dots" : "the plain pair"};
}

Measurement measured(Context& context, const CloudRequest& request) {
  if (!request.frames.empty()) return ofFilm(context, request);
  if (request.frame) return ofFrame(context, capture::openRecording(request.recording), request.frame);
  const auto recording = capture::openCapture(request.recording);
  if (recording.capture) return ofCapture(context, recording, request.is_plain);
  if (request.is_plain)
    throw Error("has no capture/ pair", recording.folder.string(), "choose a frame of the film with --frame");
  if (recording.frame_count == 0)
    throw Error("has neither a capture/ pair nor frames", recording.folder.string(), "record one first");
  return ofFrame(context, recording, std::nullopt);
}

void runCloud(Context& context, const CloudRequest& request) {
  const Measurement result = measured(context, request);
  const auto& cloud = result.face.cloud;
  writeWholeFile(request.output,
                 stereo::plyText(cloud, result.colour.empty() ? result.face.first->left : result.colour));
  if (context.is_quiet) return;
  std::printf("%zu points of %s, in %s, from %s: %s\n", cloud.face.cloud.size(),
              result.face.landmarks.centre ? "the face" : "the nearest surface (no face was found)",
              result.colour.empty() ? "grey" : "colour", result.what.c_str(), request.output.c_str());
}

}  // namespace

void addCloud(CLI::App& app, Context& context) {
  auto* verb = app.add_subcommand("cloud", "the face as measured -> PLY with normals and uncertainty");
  auto request = std::make_shared<CloudRequest>();
  verb->add_option("RECORDING", request->recording, "recording folder with stereo.yml")->required();
  auto* frame =
      verb->add_option("--frame", request->frame, "this frame of the film (default: the capture pair)");
  auto* frames = verb->add_option("--frames", request->frames,
                                  "these frames of the film, N..M, fused into one face by the head's motion")
                     ->check(checkRange)
                     ->excludes(frame);
  verb->add_flag("--plain", request->is_plain, "the capture's pair without dots")
      ->excludes(frame)
      ->excludes(frames);
  verb->add_option("-o,--output", request->output, "face.ply to write (Camera frame, mm)")->required();
  verb->callback([&context, request] { runCloud(context, *request); });
}

}  // namespace facenav::app
