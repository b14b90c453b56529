#include "facenav/align/stored_capture.h"

#include "facenav/geometry/pose_error.h"

namespace facenav::steps {
namespace fs = std::filesystem;
namespace {

fs::path folderIn(const fs::path& case_folder) { return case_folder / "alignment_capture"; }

bool isSameRig(const cameras::StereoRig& a, const cameras::StereoRig& b) {
  const auto motion = poseError(a.right_T_left, b.right_T_left);
  return a.width_px == b.width_px && a.height_px == b.height_px && cv::norm(a.left.k - b.left.k) < 1e-3 &&
         cv::norm(a.right.k - b.right.k) < 1e-3 && motion.rotation_rad < 1e-6 && motion.translation_mm < 1e-4;
}

}  // namespace

void writeStoredCapture(const casefile::FileGroup& group, const cameras::StereoRig& rig,
                        const capture::CapturePair& pair) {
  capture::RecordingWriter writer(folderIn(group.staging()), rig);
  writer.setCapture(pair);
  writer.close();
}

std::optional<capture::CapturePair> readStoredCapture(const fs::path& case_folder,
                                                      const cameras::StereoRig& rig) {
  if (!fs::exists(folderIn(case_folder))) return std::nullopt;
  const auto stored = capture::openCapture(folderIn(case_folder));
  if (!isSameRig(stored.rig, rig))
    throw Error("the case was aligned with another camera rig than this recording's", case_folder.string(),
                "align again with a capture of this rig");
  return stored.capture;
}

}  // namespace facenav::steps
