// The capture pair stored with a case's alignment: it identifies the cameras that the alignment is valid for.

#include "facenav/align/stored_capture.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <atomic>
#include <set>
#include <thread>

#include "facenav/align/align_case.h"
#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "support/stereo_rigs.h"
#include "support/test_data.h"

namespace facenav::steps {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

namespace fs = std::filesystem;

capture::CapturePair someCapture(const cameras::StereoRig& rig, int grey = 90) {
  capture::CapturePair pair;
  for (cameras::StereoFrame* frame : {&pair.pattern, &pair.plain})
    for (cv::Mat* image : {&frame->left, &frame->right})
      *image = cv::Mat(rig.height_px, rig.width_px, CV_8U, cv::Scalar(grey));
  return pair;
}

void store(const fs::path& folder, const cameras::StereoRig& rig, const capture::CapturePair& pair) {
  casefile::FileGroup group(folder);
  writeStoredCapture(group, rig, pair);
  group.commit("alignment_capture");
}

/// Outcome of a fit with this residual and a face without points.
AlignmentOutcome outcomeOf(double rms_mm) {
  AlignmentOutcome outcome;
  outcome.result.rms_mm = rms_mm;
  return outcome;
}

casefile::CaseStore someCase(const fs::path& folder) {
  casefile::PreparedCase prepared;
  prepared.mri.grid.size = prepared.head_mask.grid.size = {2, 2, 2};
  prepared.mri.voxels.assign(8, 1.f);
  prepared.head_mask.voxels.assign(8, 1);
  prepared.scalp.mesh.vertices_mm = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  prepared.scalp.mesh.normals.assign(3, Eigen::Vector3d::UnitZ());
  prepared.scalp.mesh.triangles = {{0, 1, 2}};
  return casefile::CaseStore::create(folder, prepared, {}, false);
}

/// Collects files of `folder` that other users could read, during its lifetime.
class OthersEyes {
 public:
  explicit OthersEyes(fs::path folder) : folder_(std::move(folder)), thread_([this] { look(); }) {}
  ~OthersEyes() { stop(); }
  std::set<std::string> stop() {
    is_stopping_ = true;
    if (thread_.joinable()) thread_.join();
    return seen_;
  }

 private:
  void look() {
    while (!is_stopping_) lookInto(folder_);
  }
  void lookInto(const fs::path& folder) {
    struct stat status {};
    if (::stat(folder.c_str(), &status) != 0 || !(status.st_mode & S_IXOTH)) return;
    std::error_code gone;
    for (fs::directory_iterator item(folder, gone), end; !gone && item != end; item.increment(gone)) {
      if (::lstat(item->path().c_str(), &status) != 0) continue;
      if (S_ISDIR(status.st_mode)) lookInto(item->path());
      if (S_ISREG(status.st_mode) && (status.st_mode & S_IROTH)) seen_.insert(item->path().string());
    }
  }
  fs::path folder_;
  std::set<std::string> seen_;
  std::atomic<bool> is_stopping_{false};
  std::thread thread_;
};

TEST(StoredCapture, AnAlignmentOfOtherCamerasIsRefusedInOneClearLine) {
  const facenav::testing::TemporaryFolder folder;
  const auto rig = facenav::testing::convergingRig();
  EXPECT_FALSE(readStoredCapture(folder.path(), rig).has_value()) << "no capture, no claim";
  store(folder.path(), rig, someCapture(rig));
  const auto same = readStoredCapture(folder.path(), rig);
  ASSERT_TRUE(same.has_value());
  EXPECT_EQ(same->pattern.left.size(), cv::Size(rig.width_px, rig.height_px));

  auto longer = rig;
  longer.left.k(0, 0) += 0.5;  // another calibration
  auto moved = rig;
  moved.right_T_left = {rig.right_T_left.quaternion(),
                        rig.right_T_left.translation_mm() + Eigen::Vector3d(0.05, 0, 0)};
  for (const auto& other : {longer, moved, facenav::testing::verticalRig()})
    EXPECT_THAT([&] { readStoredCapture(folder.path(), other); },
                ThrowsMessage<Error>(HasSubstr("aligned with another camera rig")));
}

TEST(StoredAlignment, ThatCannotBeWrittenWholeLeavesTheOneOfBeforeWhole) {
  const facenav::testing::TemporaryFolder folder;
  const auto rig = facenav::testing::convergingRig();
  const auto store = someCase(folder.path() / "case");
  storeAlignment(store, rig, someCapture(rig, 90), outcomeOf(0.5));
  const std::string fit = readWholeFile(store.folder() / "skin_fit.vtp");
  fs::remove(store.folder() / "skin_fit.png");
  fs::create_directories(store.folder() / "skin_fit.png" / "not ours");  // cannot be replaced
  EXPECT_THROW(storeAlignment(store, rig, someCapture(rig, 10), outcomeOf(0.9)), Error);
  EXPECT_EQ(store.alignment()->rms_mm, 0.5);
  EXPECT_EQ(readStoredCapture(store.folder(), rig)->plain.left.at<unsigned char>(0, 0), 90);
  EXPECT_EQ(readWholeFile(store.folder() / "skin_fit.vtp"), fit);
  EXPECT_TRUE(fs::exists(store.folder() / "skin_fit.png" / "not ours"));
  fs::remove_all(store.folder() / "skin_fit.png");
  storeAlignment(store, rig, someCapture(rig, 10), outcomeOf(0.9));
  EXPECT_EQ(store.alignment()->rms_mm, 0.9);
  EXPECT_EQ(readStoredCapture(store.folder(), rig)->plain.left.at<unsigned char>(0, 0), 10);
}

TEST(StoredAlignment, NoFileOfItCanEverBeReadByOthers) {
  const facenav::testing::TemporaryFolder folder;
  const auto rig = facenav::testing::convergingRig();
  const auto store = someCase(folder.path() / "case");
  fs::permissions(store.folder(), fs::perms(0755));  // for example, a copied case
  const mode_t before = ::umask(022);
  OthersEyes eyes(store.folder());
  for (int i = 0; i < 5; ++i) storeAlignment(store, rig, someCapture(rig), outcomeOf(0.5));
  const auto seen = eyes.stop();
  ::umask(before);
  EXPECT_TRUE(seen.empty()) << seen.size() << " files, the first: " << *seen.begin();
  for (const char* name : {"alignment.json", "skin_fit.vtp", "skin_fit.png"})
    EXPECT_EQ(fs::status(store.folder() / name).permissions(), fs::perms(0600)) << name;
  EXPECT_EQ(fs::status(store.folder() / "alignment_capture").permissions(), fs::perms(0700));
}

}  // namespace
}  // namespace facenav::steps
