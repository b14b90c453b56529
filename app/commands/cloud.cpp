// facenav cloud RECORDING [--frame N] [--plain] -o face.ply: the face as the cameras measure it.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <opencv2/core.hpp>

#include "commands/commands.h"
#include "facenav/capture/recording.h"
#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "facenav/session/align_from_capture.h"
#include "facenav/stereo/face_cloud.h"

namespace facenav::app {
namespace {

struct CloudRequest {
  std::filesystem::path recording, output;
  std::optional<std::int64_t> frame;
  bool is_plain = false;
};

/// To measure, and to find the face in.
struct Pictures {
  stereo::StereoFrame measured, plain;
  std::string what;  // in words
};

Pictures frameOf(const capture::Recording& recording, std::int64_t number) {
  const auto source = capture::makeSource(recording);
  while (const auto frame = source->next())
    if (frame->number == number) return {*frame, *frame, "frame " + std::to_string(number)};
  throw Error("has no frame " + std::to_string(number), recording.folder.string(),
              "it has " + std::to_string(recording.frame_count) + " frames");
}

Pictures picturesOf(const capture::Recording& recording, const CloudRequest& request) {
  if (request.frame) return frameOf(recording, *request.frame);
  if (request.is_plain && !recording.capture)
    throw Error("has no capture/ pair", recording.folder.string(), "choose a frame of the film with --frame");
  if (request.is_plain) return {recording.capture->plain, recording.capture->plain, "the plain pair"};
  if (recording.capture) return {recording.capture->pattern, recording.capture->plain, "the pair with dots"};
  const auto source = capture::makeSource(recording);
  if (const auto first = source->next()) return {*first, *first, "the film's first frame"};
  throw Error("has neither a capture/ pair nor frames", recording.folder.string(), "record one first");
}

/// ASCII PLY, Camera frame, mm; grey of the left image as red, green, blue.
std::string plyText(const stereo::FaceCloud& face, const cv::Mat& left) {
  std::string text = "ply\nformat ascii 1.0\ncomment frame: Camera, mm\nelement vertex " +
                     std::to_string(face.cloud.size()) + "\n";
  for (const char* name : {"x", "y", "z", "nx", "ny", "nz"})
    text += std::string("property float ") + name + "\n";
  for (const char* name : {"red", "green", "blue"}) text += std::string("property uchar ") + name + "\n";
  text += "property float sigma_mm\nend_header\n";
  for (std::size_t i = 0; i < face.cloud.size(); ++i) {
    const Eigen::Vector3d &p = face.cloud.points_mm[i], &n = face.cloud.normals[i];
    const int column = std::clamp(int(std::lround(face.left_px[i].x())), 0, left.cols - 1);
    const int row = std::clamp(int(std::lround(face.left_px[i].y())), 0, left.rows - 1);
    const int grey = left.at<unsigned char>(row, column);
    char line[200];
    std::snprintf(line, sizeof line, "%.4f %.4f %.4f %.5f %.5f %.5f %d %d %d %.4f\n", p.x(), p.y(), p.z(),
                  n.x(), n.y(), n.z(), grey, grey, grey, double(face.sigma_mm[i]));
    text += line;
  }
  return text;
}

void runCloud(Context& context, const CloudRequest& request) {
  const auto recording =
      request.frame ? capture::openRecording(request.recording) : capture::openCapture(request.recording);
  const Pictures pictures = picturesOf(recording, request);
  const auto landmarks =
      session::findFace(recording.rig, pictures.plain, *context.registrations.face_detector());
  stereo::FaceCloudOptions options;
  if (landmarks.centre) {  // a hand's breadth and a half before and behind the face
    options.nearest_mm = std::max(100.0, landmarks.centre->mm.z() - 180.0);
    options.farthest_mm = landmarks.centre->mm.z() + 220.0;
  }
  const auto face = session::cutFace(
      stereo::measureFace(recording.rig, pictures.measured, options, context.monitor), landmarks);
  if (face.cloud.empty())
    throw Error("no point of a face was measured", request.recording.string(),
                "let the face look towards both cameras, or choose another frame");
  writeWholeFile(request.output, plyText(face, pictures.plain.left));
  if (!context.is_quiet)
    std::printf("%zu points of %s, from %s: %s\n", face.cloud.size(),
                landmarks.centre ? "the face" : "the nearest surface (no face was found)",
                pictures.what.c_str(), request.output.c_str());
}

}  // namespace

void addCloud(CLI::App& app, Context& context) {
  auto* verb = app.add_subcommand("cloud", "the face as measured -> PLY with normals and uncertainty");
  auto request = std::make_shared<CloudRequest>();
  verb->add_option("RECORDING", request->recording, "recording folder with stereo.yml")->required();
  auto* frame =
      verb->add_option("--frame", request->frame, "this frame of the film (default: the capture pair)");
  verb->add_flag("--plain", request->is_plain, "the capture's pair without dots")->excludes(frame);
  verb->add_option("-o,--output", request->output, "face.ply to write (Camera frame, mm)")->required();
  verb->callback([&context, request] { runCloud(context, *request); });
}

}  // namespace facenav::app
