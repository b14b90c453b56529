#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cstdio>
#include <opencv2/imgcodecs.hpp>

#include "facenav/capture/recording.h"
#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "recording_frames.h"

namespace facenav::capture {
namespace fs = std::filesystem;
namespace {

std::string numbered(std::int64_t number) {
  char name[32];
  std::snprintf(name, sizeof name, "%06lld.png", static_cast<long long>(number));
  return name;
}

void writeImage(const cv::Mat& image, const fs::path& path) {
  bool is_written = false;
  try {
    is_written = cv::imwrite(path.string(), image, {cv::IMWRITE_PNG_COMPRESSION, 1});
  } catch (const cv::Exception&) {
  }
  if (!is_written) throw Error("image cannot be written", path.string(), "check free disk space");
}

std::string poseLine(std::int64_t frame, const Eigen::Isometry3d& pose) {
  const auto t = RigidTransform<Camera, Mri>::fromIsometry(pose);
  const Eigen::Vector3d p = t.translation_mm();
  const Eigen::Quaterniond q = t.quaternion();
  char line[256];
  std::snprintf(line, sizeof line, "%lld,%.9g,%.9g,%.9g,%.12g,%.12g,%.12g,%.12g\n",
                static_cast<long long>(frame), p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z());
  return line;
}

fs::path makeTemporaryFolder(const fs::path& folder) {
  static std::atomic<int> counter{0};
  const fs::path parent = folder.has_parent_path() ? folder.parent_path() : fs::path(".");
  const std::string name = ".tmp" + std::to_string(::getpid()) + "_" + std::to_string(counter++) + "_" +
                           folder.filename().string();
  std::error_code error;
  if (!fs::create_directories(parent / name / "left", error) ||
      !fs::create_directory(parent / name / "right", error))
    throw Error("folder cannot be made (" + error.message() + ")", folder.string(), "choose another place");
  return parent / name;
}

// All files of the folder's file system at once: one fsync per image would take longer than the images.
void syncToDisk(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY);
  const bool is_synced = descriptor >= 0 && ::syncfs(descriptor) == 0;
  if (descriptor >= 0) ::close(descriptor);
  if (!is_synced) throw Error("cannot be written", folder.string(), "check free disk space");
}

}  // namespace

struct RecordingWriter::Implementation {
  fs::path folder, temporary;
  stereo::StereoRig rig;
  std::string timestamps = "frame,t_s\n", head_truth, coil_truth;
  std::optional<std::int64_t> last_number;
  double last_s = 0;
  bool is_closed = false;

  void requireOpen() const { FACENAV_EXPECT(!is_closed, "the recording is closed"); }
};

RecordingWriter::RecordingWriter(const fs::path& folder, const stereo::StereoRig& rig)
    : implementation_(std::make_unique<Implementation>()) {
  Implementation& self = *implementation_;
  const std::string text = folder.string();  // "rec/" has an empty file name
  self.folder = text.size() > 1 && text.back() == '/' ? folder.parent_path() : folder;
  self.rig = rig;
  if (fs::exists(self.folder) && !(fs::is_directory(self.folder) && fs::is_empty(self.folder)))
    throw Error("already exists", self.folder.string(), "choose another name or remove it");
  self.temporary = makeTemporaryFolder(self.folder);
  try {
    stereo::writeRig(rig, self.temporary / "stereo.yml");
  } catch (...) {
    fs::remove_all(self.temporary);
    throw;
  }
}

RecordingWriter::~RecordingWriter() {
  if (implementation_->is_closed) return;
  std::error_code ignored;
  fs::remove_all(implementation_->temporary, ignored);
}

void RecordingWriter::add(const stereo::StereoFrame& frame) {
  Implementation& self = *implementation_;
  self.requireOpen();
  requireRigSize(self.rig, frame.left, frame.right, self.folder.string());
  FACENAV_EXPECT(!self.last_number || (frame.number > *self.last_number && frame.captured.s > self.last_s),
                 "frame numbers and times must rise");
  writeImage(frame.left, self.temporary / "left" / numbered(frame.number));
  writeImage(frame.right, self.temporary / "right" / numbered(frame.number));
  char line[64];
  std::snprintf(line, sizeof line, "%lld,%.9f\n", static_cast<long long>(frame.number), frame.captured.s);
  self.timestamps += line;
  self.last_number = frame.number;
  self.last_s = frame.captured.s;
}

void RecordingWriter::setCapture(const CapturePair& pair) {
  Implementation& self = *implementation_;
  self.requireOpen();
  const fs::path capture = self.temporary / "capture";
  fs::create_directories(capture);
  for (const auto& [name, frame] : {std::pair("pattern", &pair.pattern), std::pair("plain", &pair.plain)}) {
    requireRigSize(self.rig, frame->left, frame->right, self.folder.string());
    writeImage(frame->left, capture / (std::string(name) + "_left.png"));
    writeImage(frame->right, capture / (std::string(name) + "_right.png"));
  }
}

void RecordingWriter::addTruth(std::int64_t frame, const std::optional<Eigen::Isometry3d>& camera_T_mri,
                               const std::optional<Eigen::Isometry3d>& camera_T_marker) {
  implementation_->requireOpen();
  if (camera_T_mri) implementation_->head_truth += poseLine(frame, *camera_T_mri);
  if (camera_T_marker) implementation_->coil_truth += poseLine(frame, *camera_T_marker);
}

const fs::path& RecordingWriter::temporaryFolder() const { return implementation_->temporary; }

void RecordingWriter::close() {
  Implementation& self = *implementation_;
  self.requireOpen();
  const std::string header = "frame,tx,ty,tz,qw,qx,qy,qz\n";
  writeWholeFile(self.temporary / "timestamps.csv", self.timestamps);
  if (!self.head_truth.empty() || !self.coil_truth.empty()) fs::create_directories(self.temporary / "truth");
  if (!self.head_truth.empty())
    writeWholeFile(self.temporary / "truth" / "head.csv", header + self.head_truth);
  if (!self.coil_truth.empty())
    writeWholeFile(self.temporary / "truth" / "coil.csv", header + self.coil_truth);
  syncToDisk(self.temporary);
  std::error_code error;
  fs::rename(self.temporary, self.folder, error);
  if (error)
    throw Error("cannot be written (" + error.message() + ")", self.folder.string(), "choose another place");
  self.is_closed = true;
}

}  // namespace facenav::capture
