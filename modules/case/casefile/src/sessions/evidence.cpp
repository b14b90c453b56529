#include "facenav/casefile/evidence.h"

#include <opencv2/imgcodecs.hpp>

#include "appended_file.h"
#include "csv_line.h"
#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/core/settings_in_force.h"
#include "facenav/core/whole_file.h"
#include "facenav/core/whole_folder.h"

namespace facenav::casefile {
namespace fs = std::filesystem;
namespace {

constexpr const char* kTimes = "timestamps.csv";
constexpr const char* kTimesHeader = "frame,t_s\n";
const char* const kSides[] = {"left", "right"};

fs::path pictureFile(const fs::path& evidence, const char* side, std::int64_t number) {
  return evidence / side / formatted("%06lld.jpg", static_cast<long long>(number));
}

std::string jpegOf(const cv::Mat& image, int quality, const fs::path& path) {
  std::vector<unsigned char> bytes;
  try {
    if (cv::imencode(".jpg", image, bytes, {cv::IMWRITE_JPEG_QUALITY, quality}))
      return {bytes.begin(), bytes.end()};
  } catch (const cv::Exception&) {
  }
  throw Error("the picture cannot be encoded", path.string());
}

/// Returns the whole lines with rising frame numbers and times.
std::string soundTimes(const fs::path& csv, std::optional<std::int64_t>& last) {
  std::string sound = kTimesHeader;
  const std::string content = fs::exists(csv) ? readWholeFile(csv) : std::string();
  double last_s = 0;
  for (std::size_t begin = 0, end; (end = content.find('\n', begin)) != std::string::npos; begin = end + 1) {
    const std::string line = content.substr(begin, end - begin);
    const auto fields = fieldsOf(line);
    const auto number = fields.size() == 2 ? numberIn(fields[0]) : std::nullopt;
    const auto t_s = fields.size() == 2 ? numberIn(fields[1]) : std::nullopt;
    if (!number || !t_s || (last && (*number <= double(*last) || *t_s <= last_s))) continue;
    last = std::int64_t(*number);
    last_s = *t_s;
    sound += line + "\n";
  }
  return sound;
}

void removeOneSided(const fs::path& evidence) {
  for (int side : {0, 1}) {
    const fs::path folder = evidence / kSides[side], other = evidence / kSides[1 - side];
    if (!fs::is_directory(folder)) continue;
    std::vector<fs::path> alone;
    for (const auto& entry : fs::directory_iterator(folder))
      if (!fs::exists(other / entry.path().filename())) alone.push_back(entry.path());
    for (const auto& picture : alone) fs::remove(picture);
  }
}

}  // namespace

fs::path evidenceFolder(const fs::path& session_folder) { return session_folder / "evidence"; }

void mendEvidence(const fs::path& session_folder) {
  const fs::path evidence = evidenceFolder(session_folder);
  if (!fs::is_directory(evidence)) return;
  try {
    removeOneSided(evidence);
    std::optional<std::int64_t> last;
    const std::string sound = soundTimes(evidence / kTimes, last);
    if (!fs::exists(evidence / kTimes) || sound != readWholeFile(evidence / kTimes))
      writeWholeFile(evidence / kTimes, sound, FileAccess::owner_only);
  } catch (const fs::filesystem_error& error) {
    throw Error("cannot be mended (" + error.code().message() + ")", evidence.string());
  }
}

std::optional<std::int64_t> evidenceFrame(const fs::path& session_folder, const Pulse& pulse) {
  if (!pulse.frames) return std::nullopt;
  const fs::path evidence = evidenceFolder(session_folder);
  const std::size_t nearer = pulse.fraction < 0.5 ? 0 : 1;
  for (const std::size_t which : {nearer, 1 - nearer}) {
    const std::int64_t number = (*pulse.frames)[which];
    if (fs::exists(pictureFile(evidence, "left", number)) &&
        fs::exists(pictureFile(evidence, "right", number)))
      return number;
  }
  return std::nullopt;
}

struct EvidenceFolder::Implementation {
  fs::path session, evidence;
  cameras::StereoRig rig;
  std::unique_ptr<AppendedFile> times;
  std::optional<std::int64_t> last;

  void open() {
    if (times && fs::exists(evidence / kTimes)) return;
    times.reset();
    if (!fs::exists(evidence)) makePrivateFolder(evidence);
    for (const char* side : kSides)
      if (!fs::exists(evidence / side)) makePrivateFolder(evidence / side);
    if (!fs::exists(evidence / "stereo.yml")) {
      cameras::writeRig(rig, evidence / "stereo.yml");
      fs::permissions(evidence / "stereo.yml", fs::perms::owner_read | fs::perms::owner_write);
    }
    mendEvidence(session);
    last.reset();
    soundTimes(evidence / kTimes, last);
    times =
        std::make_unique<AppendedFile>(evidence / kTimes, kTimesHeader, AppendedFile::Start::old_or_fresh);
  }
};

EvidenceFolder::EvidenceFolder(fs::path session_folder, const cameras::StereoRig& rig)
    : implementation_(std::make_unique<Implementation>()) {
  implementation_->evidence = evidenceFolder(session_folder);
  implementation_->session = std::move(session_folder);
  implementation_->rig = rig;
}

EvidenceFolder::~EvidenceFolder() = default;

/// The line is written first: a recording may have a line without pictures, but not pictures without a line.
bool EvidenceFolder::keep(const cameras::StereoFrame& frame) {
  Implementation& self = *implementation_;
  const int quality = settingsOf<EvidenceRules>().jpeg_quality;
  if (quality <= 0) return false;
  self.open();
  if (self.last && frame.number <= *self.last) return false;
  const fs::path left = pictureFile(self.evidence, "left", frame.number);
  const fs::path right = pictureFile(self.evidence, "right", frame.number);
  const std::string left_jpeg = jpegOf(frame.left, quality, left),
                    right_jpeg = jpegOf(frame.right, quality, right);
  self.times->append(formatted("%lld,%.9f\n", static_cast<long long>(frame.number), frame.captured.s));
  self.last = frame.number;
  writeWholeFile(left, left_jpeg, FileAccess::owner_only);
  try {
    writeWholeFile(right, right_jpeg, FileAccess::owner_only);
  } catch (...) {
    std::error_code ignored;
    fs::remove(left, ignored);
    throw;
  }
  return true;
}

}  // namespace facenav::casefile
