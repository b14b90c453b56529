#include <fstream>
#include <opencv2/imgcodecs.hpp>

#include "facenav/capture/recording.h"
#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/core/whole_file.h"
#include "facenav/core/whole_folder.h"
#include "recording_frames.h"

namespace facenav::capture {
namespace fs = std::filesystem;
namespace {

std::string numbered(std::int64_t number) { return formatted("%06lld.png", static_cast<long long>(number)); }

void writeImage(const cv::Mat& image, const fs::path& path) {
  // Does not use cv::imwrite: on a full disk libpng would write a line of its own.
  std::vector<unsigned char> png;
  cv::imencode(".png", image, png, {cv::IMWRITE_PNG_COMPRESSION, 1});
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(png.data()), std::streamsize(png.size()));
  if (!file.flush()) throw Error("image cannot be written", path.string(), "check free disk space");
}

std::string poseLine(std::int64_t frame, const Eigen::Isometry3d& pose) {
  const auto t = RigidTransform<Camera, Mri>::fromIsometry(pose);
  const Eigen::Vector3d p = t.translation_mm();
  const Eigen::Quaterniond q = t.quaternion();
  return formatted("%lld,%.9g,%.9g,%.9g,%.12g,%.12g,%.12g,%.12g\n", static_cast<long long>(frame), p.x(),
                   p.y(), p.z(), q.w(), q.x(), q.y(), q.z());
}

/// Content of timestamps.csv; it has the column right_t_s only if some frame has that time.
std::string timestampsFile(const std::string& lines, bool has_right_times) {
  if (has_right_times) return "frame,t_s,right_t_s\n" + lines;
  std::string without = "frame,t_s\n";
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (lines[i] != ',' || lines[i + 1] != '\n') without += lines[i];
  return without;
}

const fs::path& withParent(const fs::path& place) {
  const fs::path named = fs::absolute(place / ".").lexically_normal().parent_path();  // "rec/" is "rec"
  std::error_code error;
  fs::create_directories(named.parent_path(), error);
  if (error)
    throw Error("folder cannot be made (" + error.message() + ")", place.string(), "choose another place");
  return place;
}

}  // namespace

struct RecordingWriter::Implementation {
  Implementation(const fs::path& place, const cameras::StereoRig& r, FileAccess access, Existing existing)
      : place_name(place.string()), folder(withParent(place), access, existing), rig(r) {}
  const fs::path& path() const { return folder.temporaryPath(); }

  std::string place_name;
  WholeFolder folder;
  cameras::StereoRig rig;
  std::string timestamps, head_truth, coil_truth, second_truth;
  bool has_right_times = false;
  std::optional<std::int64_t> last_number;
  double last_s = 0;
  bool is_closed = false;

  void requireOpen() const { FACENAV_EXPECT(!is_closed, "the recording is closed"); }
};

RecordingWriter::RecordingWriter(const fs::path& folder, const cameras::StereoRig& rig, FileAccess access,
                                 Existing existing)
    : implementation_(std::make_unique<Implementation>(folder, rig, access, existing)) {
  for (const char* side : {"left", "right"}) fs::create_directory(implementation_->path() / side);
  cameras::writeRig(rig, implementation_->path() / "stereo.yml");
}

RecordingWriter::~RecordingWriter() = default;

void RecordingWriter::add(const cameras::StereoFrame& frame) {
  Implementation& self = *implementation_;
  self.requireOpen();
  requireRigSize(self.rig, frame.left, frame.right, self.place_name);
  FACENAV_EXPECT(!self.last_number || (frame.number > *self.last_number && frame.captured.s > self.last_s),
                 "frame numbers and times must rise");
  writeImage(frame.left, self.path() / "left" / numbered(frame.number));
  writeImage(frame.right, self.path() / "right" / numbered(frame.number));
  self.timestamps += formatted("%lld,%.9f,", static_cast<long long>(frame.number), frame.captured.s);
  if (frame.right_late_s) self.timestamps += formatted("%.9f", frame.captured.s + *frame.right_late_s);
  self.timestamps += "\n";
  self.has_right_times |= frame.right_late_s.has_value();
  self.last_number = frame.number;
  self.last_s = frame.captured.s;
}

void RecordingWriter::setCapture(const CapturePair& pair) {
  Implementation& self = *implementation_;
  self.requireOpen();
  const fs::path capture = self.path() / "capture";
  fs::create_directories(capture);
  for (const auto& [name, frame] : {std::pair("pattern", &pair.pattern), std::pair("plain", &pair.plain)}) {
    if (frame == &pair.pattern && frame->left.empty()) continue;  // no projector
    requireRigSize(self.rig, frame->left, frame->right, self.place_name);
    writeImage(frame->left, capture / (std::string(name) + "_left.png"));
    writeImage(frame->right, capture / (std::string(name) + "_right.png"));
  }
}

void RecordingWriter::addTruth(std::int64_t frame, const std::optional<Eigen::Isometry3d>& camera_T_mri,
                               const std::optional<Eigen::Isometry3d>& camera_T_marker,
                               const std::optional<Eigen::Isometry3d>& camera_T_second_marker) {
  implementation_->requireOpen();
  if (camera_T_mri) implementation_->head_truth += poseLine(frame, *camera_T_mri);
  if (camera_T_marker) implementation_->coil_truth += poseLine(frame, *camera_T_marker);
  if (camera_T_second_marker) implementation_->second_truth += poseLine(frame, *camera_T_second_marker);
}

const fs::path& RecordingWriter::temporaryFolder() const { return implementation_->path(); }

void RecordingWriter::close() {
  Implementation& self = *implementation_;
  self.requireOpen();
  const std::string header = "frame,tx,ty,tz,qw,qx,qy,qz\n";
  writeWholeFile(self.path() / "timestamps.csv", timestampsFile(self.timestamps, self.has_right_times));
  if (!self.head_truth.empty() || !self.coil_truth.empty() || !self.second_truth.empty())
    fs::create_directories(self.path() / "truth");
  if (!self.head_truth.empty()) writeWholeFile(self.path() / "truth" / "head.csv", header + self.head_truth);
  if (!self.coil_truth.empty()) writeWholeFile(self.path() / "truth" / "coil.csv", header + self.coil_truth);
  if (!self.second_truth.empty())
    writeWholeFile(self.path() / "truth" / "coil2.csv", header + self.second_truth);
  self.folder.commit();
  self.is_closed = true;
}

}  // namespace facenav::capture
