#include "guided_time.h"

#include <algorithm>
#include <fstream>
#include <string>

#include "csv_line.h"

namespace facenav::casefile {
namespace {

constexpr double kLongestGap_s = 0.25;        // as session::SessionOptions::age_limit_s
constexpr double kBreak_s = 1.0;              // the program did not run, paused, or had no target
constexpr std::streamoff kTail_bytes = 4096;  // many lines

void add(GuidedTime& time, const std::string& state, double step_s) {
  const double known_s = std::min(step_s, kLongestGap_s);
  double& of_state = state == "on_target" ? time.on_target_s
                     : state == "adjust"  ? time.adjust_s
                                          : time.lost_s;
  of_state += known_s;
  if (step_s < kBreak_s) time.lost_s += step_s - known_s;
}

}  // namespace

std::optional<GuidedTime> readGuidedTime(const std::filesystem::path& guidance_csv) {
  std::ifstream stream(guidance_csv);
  std::string line;
  if (!std::getline(stream, line)) return std::nullopt;
  const auto t_column = columnOf(line, "t_s"), state_column = columnOf(line, "state");
  if (!t_column || !state_column) return std::nullopt;
  GuidedTime time;
  std::optional<double> last_s;
  std::string last_state;
  int frames = 0;
  while (std::getline(stream, line)) {
    const auto t_s = numberAt(line, *t_column);
    const auto state = fieldAt(line, *state_column);
    if (!t_s || !state) continue;
    if (last_s && *t_s > *last_s) add(time, last_state, *t_s - *last_s);
    last_s = t_s;
    last_state = *state;
    ++frames;
  }
  if (frames < 2) return std::nullopt;
  return time;
}

std::optional<double> readDuration_s(const std::filesystem::path& poses_csv) {
  std::ifstream stream(poses_csv);
  std::string line;
  if (!std::getline(stream, line)) return std::nullopt;
  const auto column = columnOf(line, "t_s");
  if (!column || !std::getline(stream, line)) return std::nullopt;
  const auto first_s = numberAt(line, *column);
  stream.seekg(0, std::ios::end);
  const std::streamoff size = stream.tellg();
  stream.seekg(std::max<std::streamoff>(0, size - kTail_bytes));
  std::optional<double> last_s;
  for (std::getline(stream, line); std::getline(stream, line);)  // the first one may be a part of a line
    if (!stream.eof())
      if (const auto t_s = numberAt(line, *column)) last_s = t_s;
  if (!first_s || !last_s || *last_s < *first_s) return std::nullopt;
  return *last_s - *first_s;
}

std::optional<LastFrame> readLastFrame(const std::filesystem::path& poses_csv) {
  std::ifstream stream(poses_csv);
  std::string line;
  if (!std::getline(stream, line)) return std::nullopt;
  const auto frame_column = columnOf(line, "frame"), t_column = columnOf(line, "t_s");
  if (!frame_column || !t_column) return std::nullopt;
  const std::streamoff after_header = stream.tellg();
  stream.seekg(0, std::ios::end);
  const std::streamoff tail = std::streamoff(stream.tellg()) - kTail_bytes;
  stream.seekg(std::max(after_header, tail));
  if (tail > after_header) std::getline(stream, line);  // it may be a part of a line
  std::optional<LastFrame> last;
  while (std::getline(stream, line)) {
    const auto frame = numberAt(line, *frame_column), t_s = numberAt(line, *t_column);
    if (stream.eof() || !frame || !t_s) continue;  // cut short
    if (!last || *frame > double(last->frame)) last = LastFrame{std::int64_t(*frame), *t_s};
  }
  return last;
}

}  // namespace facenav::casefile
