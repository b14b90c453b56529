#include "guided_time.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <string>
#include <vector>

namespace facenav::casefile {
namespace {

constexpr double kLongestGap_s = 0.25;        // as session::SessionOptions::age_limit_s
constexpr std::streamoff kTail_bytes = 4096;  // many lines

/// The field at `column` of a line; a field may be quoted and then holds commas.
std::optional<std::string> fieldAt(const std::string& line, std::size_t column) {
  bool is_quoted = false;
  std::size_t begin = 0, at = 0;
  for (std::size_t i = 0; i <= line.size(); ++i) {
    if (i < line.size() && line[i] == '"') is_quoted = !is_quoted;
    if (i < line.size() && (line[i] != ',' || is_quoted)) continue;
    if (at++ == column) return line.substr(begin, i - begin);
    begin = i + 1;
  }
  return std::nullopt;
}

std::optional<std::size_t> columnOf(const std::string& header, const std::string& name) {
  for (std::size_t column = 0;; ++column) {
    const auto field = fieldAt(header, column);
    if (!field) return std::nullopt;
    if (*field == name) return column;
  }
}

std::optional<double> numberAt(const std::string& line, std::size_t column) {
  const auto field = fieldAt(line, column);
  double value = 0;
  if (!field) return std::nullopt;
  const auto [end, fault] = std::from_chars(field->data(), field->data() + field->size(), value);
  if (fault != std::errc() || end != field->data() + field->size()) return std::nullopt;
  return value;
}

void add(GuidedTime& time, const std::string& state, double step_s) {
  const double known_s = std::min(step_s, kLongestGap_s);
  double& of_state = state == "on_target" ? time.on_target_s
                     : state == "adjust"  ? time.adjust_s
                                          : time.lost_s;
  of_state += known_s;
  time.lost_s += step_s - known_s;
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

}  // namespace facenav::casefile
