#include "facenav/casefile/session_track.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <map>

#include "csv_line.h"
#include "facenav/core/error.h"
#include "facenav/core/number_text.h"

namespace facenav::casefile {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kMostWords = 1000;
constexpr std::array<const char*, 7> kPoseColumns{"tx", "ty", "tz", "qw", "qx", "qy", "qz"};
constexpr std::array<const char*, 7> kGuidanceColumns{
    "distance_mm", "lateral_mm", "depth_mm", "tilt_deg", "twist_deg", "beam_miss_mm", "predicted_error_mm"};

/// Column numbers by name, for the fields of each line.
class Header {
 public:
  Header(const std::string& line, const fs::path& path) : names_(fieldsOf(line)), path_(path) {}
  std::size_t at(const std::string& name) const {
    const auto found = find(name);
    if (!found) throw Error("has no column " + name, path_.string(), "is this the right file?");
    return *found;
  }
  std::optional<std::size_t> find(const std::string& name) const {
    const auto it = std::find(names_.begin(), names_.end(), name);
    return it == names_.end() ? std::nullopt : std::optional(std::size_t(it - names_.begin()));
  }
  std::size_t size() const { return names_.size(); }

 private:
  std::vector<std::string> names_;
  fs::path path_;
};

/// Numbers of columns of guidance.csv before and after two were added. One version continued older files with
/// both new values but without a header for them.
constexpr std::size_t kBeforeGaps = 11, kWithGaps = 13;

bool fits(std::size_t fields, std::size_t columns) {
  return fields == columns || (columns == kBeforeGaps && fields == kWithGaps);
}

/// Reads a file line by line; `take` returns whether the fields were good.
template <class Take>
int readLines(std::ifstream& stream, const Header& header, Take take) {
  int damaged = 0;
  std::string line;
  while (std::getline(stream, line)) {
    const bool is_torn = stream.eof();  // no newline: the program ended while it wrote
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.empty()) continue;
    const auto fields = fieldsOf(line);
    if (is_torn || !fits(fields.size(), header.size()) || !take(fields)) ++damaged;
  }
  return damaged;
}

class TrackReader {
 public:
  void readPoses(const fs::path& path);
  void readGuidance(const fs::path& path);
  SessionTrack track;

 private:
  std::uint16_t indexOf(const std::string& word);
  TrackMoment& momentOf(std::int64_t frame, double t_s);
  void note(int damaged, const fs::path& path);
  std::map<std::string, std::uint16_t> indices_{{"", std::uint16_t(0)}};
};

std::uint16_t TrackReader::indexOf(const std::string& word) {
  const auto known = indices_.find(word);
  if (known != indices_.end()) return known->second;
  if (track.words.size() >= kMostWords) return 0;
  track.words.push_back(word);
  return indices_[word] = std::uint16_t(track.words.size() - 1);
}

/// Returns the frame's moment: the last one, or a new one, since lines are in the order of their frames.
TrackMoment& TrackReader::momentOf(std::int64_t frame, double t_s) {
  if (!track.moments.empty() && track.moments.back().frame == frame) return track.moments.back();
  track.moments.emplace_back();
  track.moments.back().frame = frame;
  track.moments.back().t_s = t_s;
  return track.moments.back();
}

void TrackReader::note(int damaged, const fs::path& path) {
  if (damaged > 0)
    track.problems.push_back(
        path.string() + ": " + std::to_string(damaged) +
        (damaged == 1 ? " line is damaged and is left out" : " lines are damaged and are left out"));
}

std::optional<TrackMoment::Pose> poseFrom(const std::vector<std::string>& fields,
                                          const std::array<std::size_t, 7>& columns) {
  TrackMoment::Pose pose;
  double norm2 = 0;
  for (int i = 0; i < 7; ++i) {
    const auto value = numberIn(fields[columns[std::size_t(i)]]);
    if (!value) return std::nullopt;
    (i < 3 ? pose.t_mm[i] : pose.q_wxyz[i - 3]) = float(*value);
    if (i >= 3) norm2 += *value * *value;
  }
  return std::abs(norm2 - 1.0) < 1e-3 ? std::optional(pose) : std::nullopt;
}

void TrackReader::readPoses(const fs::path& path) {
  std::ifstream stream(path);
  std::string line;
  if (!std::getline(stream, line))
    throw Error("there are no poses to replay", path.string(), "the session has none");
  const Header header(line, path);
  const std::size_t frame = header.at("frame"), t_s = header.at("t_s"), object = header.at("object"),
                    status = header.at("status"), reason = header.at("reason");
  const auto of_frame = header.find("of_frame");
  std::array<std::size_t, 7> columns;
  for (std::size_t i = 0; i < 7; ++i) columns[i] = header.at(kPoseColumns[i]);
  note(readLines(stream, header,
                 [&](const std::vector<std::string>& fields) {
                   const auto number = numberIn(fields[frame]), time_s = numberIn(fields[t_s]);
                   const bool is_head = fields[object] == "head";
                   const bool is_tracked = fields[status] == "tracked";
                   if (!number || !time_s || (!is_head && fields[object] != "coil")) return false;
                   if (!is_tracked && fields[status] != "lost") return false;
                   const auto pose = is_tracked ? poseFrom(fields, columns) : std::nullopt;
                   if (is_tracked && !pose) return false;
                   if (!track.moments.empty() && *time_s < track.moments.back().t_s) return false;
                   TrackMoment& moment = momentOf(std::int64_t(*number), *time_s);
                   (is_head ? moment.has_head : moment.has_coil) = is_tracked;
                   if (pose) (is_head ? moment.head : moment.coil) = *pose;
                   if (!is_tracked)
                     (is_head ? moment.head_reason : moment.coil_reason) = indexOf(fields[reason]);
                   if (of_frame && fields[*of_frame] == "head") track.is_in_mri = false;
                   if (of_frame && fields[*of_frame] == "marker") track.is_coil = false;
                   return true;
                 }),
       path);
}

void TrackReader::readGuidance(const fs::path& path) {
  std::ifstream stream(path);
  std::string line;
  if (!std::getline(stream, line)) return;
  const Header header(line, path);
  const std::size_t frame = header.at("frame"), target = header.at("target"), state = header.at("state");
  std::array<std::size_t, 7> columns;
  for (std::size_t i = 0; i < 7; ++i) columns[i] = header.at(kGuidanceColumns[i]);
  std::size_t next = 0;  // both files are in the order of their frames
  note(readLines(stream, header,
                 [&](const std::vector<std::string>& fields) {
                   const auto number = numberIn(fields[frame]);
                   if (!number) return false;
                   while (next < track.moments.size() && track.moments[next].frame < std::int64_t(*number))
                     ++next;
                   if (next == track.moments.size() || track.moments[next].frame != std::int64_t(*number))
                     return true;  // guidance of a frame that poses.csv lacks
                   TrackMoment& moment = track.moments[next];
                   std::array<float, 7> values{};
                   const bool is_lost = fields[state] == "lost";
                   for (std::size_t i = 0; i < 7 && !is_lost; ++i) {
                     const auto value = numberIn(fields[columns[i]]);
                     if (!value) return false;
                     values[i] = float(*value);
                   }
                   moment.target = indexOf(fields[target]);
                   moment.state = indexOf(fields[state]);
                   moment.has_guidance = !is_lost;
                   moment.guidance = {values[0], values[1], values[2], values[3],
                                      values[4], values[5], values[6]};
                   return true;
                 }),
       path);
}

template <class To, class From>
RigidTransform<To, From> transformOf(const TrackMoment::Pose& pose) {
  return {Eigen::Quaterniond(pose.q_wxyz[0], pose.q_wxyz[1], pose.q_wxyz[2], pose.q_wxyz[3]),
          Eigen::Vector3d(pose.t_mm[0], pose.t_mm[1], pose.t_mm[2])};
}

}  // namespace

std::optional<RigidTransform<Camera, Mri>> TrackMoment::camera_T_mri() const {
  return has_head ? std::optional(transformOf<Camera, Mri>(head)) : std::nullopt;
}

std::optional<RigidTransform<Camera, Coil>> TrackMoment::camera_T_coil() const {
  return has_coil ? std::optional(transformOf<Camera, Coil>(coil)) : std::nullopt;
}

std::size_t SessionTrack::at(double t_s) const {
  const auto later = std::upper_bound(moments.begin(), moments.end(), t_s,
                                      [](double t, const TrackMoment& m) { return t < m.t_s; });
  return later == moments.begin() ? 0 : std::size_t(later - moments.begin()) - 1;
}

SessionTrack readSessionTrack(const fs::path& poses_csv, const fs::path& guidance_csv) {
  TrackReader reader;
  reader.readPoses(poses_csv);
  reader.readGuidance(guidance_csv);
  return std::move(reader.track);
}

}  // namespace facenav::casefile
