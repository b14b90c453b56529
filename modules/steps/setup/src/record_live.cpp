#include "facenav/setup/record_live.h"

#include <algorithm>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/core/robust_statistics.h"
#include "facenav/session/recorder.h"

namespace facenav::steps {
namespace fs = std::filesystem;
namespace {

// Estimated size of a picture as PNG. Noisy grey pictures of webcams take 0.5 to 0.75 bytes a pixel.
constexpr double kBytesPerPixel = 0.8;
constexpr double kSpare_bytes = 50e6;

/// Returns the nearest existing folder above.
fs::path existingAbove(fs::path folder) {
  std::error_code ignored;
  folder = fs::absolute(folder);
  while (!fs::exists(folder, ignored) && folder.has_relative_path()) folder = folder.parent_path();
  return folder;
}

void requireSpace(const RecordRequest& request, const cameras::StereoRig& rig) {
  std::error_code error;
  const auto space = fs::space(existingAbove(request.folder), error);
  const double second_bytes = 2.0 * rig.width_px * rig.height_px * kBytesPerPixel * request.frames_per_s;
  if (error || double(space.available) >= request.seconds * second_bytes + kSpare_bytes) return;
  const double fits_s = std::max(0.0, (double(space.available) - kSpare_bytes) / second_bytes);
  throw Error(formatted("the disk has space for %.0f s only, %.0f s are asked for", fits_s, request.seconds),
              request.folder.string(), "free some space, or record a shorter time");
}

std::size_t queueLimit(const RecordRequest& request, const cameras::StereoRig& rig) {
  const std::size_t pair_bytes = 2 * std::size_t(rig.width_px) * std::size_t(rig.height_px);
  return std::max<std::size_t>(30, request.most_waiting_bytes / std::max<std::size_t>(1, pair_bytes));
}

/// Statistics of the frames during recording.
struct RecordingSoFar {
  std::optional<double> first_s;
  double last_s = 0;
  std::int64_t frames = 0;
  std::vector<double> late_ms;

  void add(const cameras::StereoFrame& frame) {
    if (!first_s) first_s = frame.captured.s;
    last_s = frame.captured.s;
    ++frames;
    if (frame.right_late_s) late_ms.push_back(1e3 * *frame.right_late_s);
  }
  double length_s() const { return first_s ? last_s - *first_s : 0.0; }
};

bool wasCancelled(TaskMonitor& monitor, double fraction) {
  try {
    monitor.report("recording", std::min(1.0, fraction));
  } catch (const Cancelled&) {
    return true;
  }
  return false;
}

/// Returns the next frame; null at the end. A camera that fails after the first frame ends the recording with
/// words.
std::shared_ptr<const cameras::StereoFrame> nextOrWords(capture::FrameSource& source, bool has_frames,
                                                        std::string& ended_by) {
  try {
    return source.next();
  } catch (const Error& error) {
    if (!has_frames) throw;
    ended_by = error.what();
    return nullptr;
  }
}

capture::CapturePair plainOnly(const cameras::StereoFrame& frame) { return {{}, frame}; }

}  // namespace

std::string RecordOutcome::words() const {
  std::string text =
      formatted("%lld pairs in %.1f s (%.1f a second)", static_cast<long long>(frames), seconds, rate);
  if (right_late_ms) text += formatted("; the right picture is %.1f ms later than the left", *right_late_ms);
  if (left_out > 0)
    text += formatted("; %lld pairs are missing: the disk was too slow", static_cast<long long>(left_out));
  return missing.empty() ? text : text + "; " + missing;
}

RecordOutcome recordLive(capture::FrameSource& source, const RecordRequest& request, TaskMonitor& monitor) {
  requireSpace(request, source.rig());
  RecordOutcome outcome;
  auto frame = source.next();
  if (!frame) throw Error("the cameras gave no picture", "", "check them with: facenav cameras --try 2");
  auto capture = request.capture;
  if (!capture && request.keeps_first_as_plain) capture = plainOnly(*frame);
  session::Recorder recorder(request.folder, source.rig(), queueLimit(request, source.rig()),
                             FileAccess::owner_only, capture ? &*capture : nullptr);
  RecordingSoFar so_far;
  while (frame) {
    so_far.add(*frame);
    recorder.add(frame);
    if (!recorder.failure().empty() || so_far.length_s() >= request.seconds) break;
    if (wasCancelled(monitor, so_far.length_s() / request.seconds)) {
      outcome.ended_by = "stopped by the user";
      break;
    }
    frame = nextOrWords(source, so_far.frames > 0, outcome.ended_by);
  }
  recorder.close();
  if (!recorder.failure().empty()) throw Error(recorder.failure() + "; nothing was kept");
  outcome.frames = std::int64_t(recorder.written());
  outcome.left_out = std::int64_t(recorder.leftOut());
  outcome.missing = source.missingPairs();
  outcome.seconds = so_far.length_s();
  if (outcome.seconds > 0) outcome.rate = double(so_far.frames - 1) / outcome.seconds;
  if (!so_far.late_ms.empty()) outcome.right_late_ms = median(so_far.late_ms);
  return outcome;
}

cameras::StereoFrame takeStill(capture::FrameSource& source) {
  const Timestamp asked = Timestamp::now();
  std::shared_ptr<const cameras::StereoFrame> frame;
  do {
    frame = source.next();
    if (!frame) throw Error("the cameras gave no more picture", "", "open them again");
  } while (frame->captured.s < asked.s);
  cameras::StereoFrame still = *frame;
  still.left = frame->left.clone();
  still.right = frame->right.clone();
  return still;
}

}  // namespace facenav::steps
