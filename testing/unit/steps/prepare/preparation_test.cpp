#include "facenav/prepare/preparation.h"

#include <gtest/gtest.h>

#include <thread>

#include "facenav/core/error.h"

namespace facenav::steps {
namespace {

constexpr double kRadius_mm = 50.0;

/// A ball of 200 in air, 2 mm voxels.
volume::Volume ballVolume() {
  volume::Volume mri;
  mri.grid.size = {70, 70, 70};
  mri.grid.mri_from_voxel.linear() *= 2.0;
  mri.grid.mri_from_voxel.translation() = Eigen::Vector3d::Constant(-69.0);
  mri.voxels.resize(mri.grid.count());
  for (int k = 0; k < 70; ++k)
    for (int j = 0; j < 70; ++j)
      for (int i = 0; i < 70; ++i)
        mri.voxels[mri.grid.index(i, j, k)] =
            mri.grid.toMri(Eigen::Vector3d(i, j, k)).mm.norm() < kRadius_mm ? 200.f : 0.f;
  return mri;
}

class BallSegmenter : public segmentation::Segmenter {
 public:
  explicit BallSegmenter(double radius_mm) : radius_mm_(radius_mm) {}
  segmentation::SegmentationResult segment(const volume::Volume& mri, TaskMonitor& monitor) const override {
    monitor.report("ball", 0.5);
    segmentation::SegmentationResult result;
    result.mask.grid = mri.grid;
    for (int k = 0; k < mri.grid.size[2]; ++k)
      for (int j = 0; j < mri.grid.size[1]; ++j)
        for (int i = 0; i < mri.grid.size[0]; ++i)
          result.mask.voxels.push_back(mri.grid.toMri(Eigen::Vector3d(i, j, k)).mm.norm() < radius_mm_);
    return result;
  }

 private:
  double radius_mm_;
};

class FailingSegmenter : public segmentation::Segmenter {
 public:
  segmentation::SegmentationResult segment(const volume::Volume&, TaskMonitor&) const override {
    throw Error("no brain can be modelled: this is a CT");
  }
};

bool mentions(const std::vector<std::string>& findings, const std::string& words) {
  for (const auto& finding : findings)
    if (finding.find(words) != std::string::npos) return true;
  return false;
}

TEST(Prepare, MakesScalpAndBrain) {
  TaskMonitor monitor;
  const auto prepared = prepare(ballVolume(), BallSegmenter(kRadius_mm), BallSegmenter(30.0), monitor);
  ASSERT_TRUE(prepared.brain && prepared.brain_mask);
  EXPECT_FALSE(prepared.scalp.mesh.triangles.empty());
  EXPECT_NEAR(prepared.brain_mask->volume_ml(), 4.0 / 3 * M_PI * 27.0, 3.0);
  // 113 ml is below the range of adults
  EXPECT_TRUE(mentions(prepared.findings, "adults have 1100 to 1700 ml"));
}

TEST(Prepare, GoesOnWithTheScalpAloneWhenNoBrainCanBeModelled) {
  TaskMonitor monitor;
  const auto prepared = prepare(ballVolume(), BallSegmenter(kRadius_mm), FailingSegmenter(), monitor);
  EXPECT_FALSE(prepared.brain);
  EXPECT_FALSE(prepared.brain_mask);
  EXPECT_FALSE(prepared.scalp.mesh.triangles.empty());
  EXPECT_TRUE(mentions(prepared.findings, "this is a CT"));
}

TEST(Prepare, WithoutAHeadThereIsNoCase) {
  TaskMonitor monitor;
  EXPECT_THROW(prepare(ballVolume(), FailingSegmenter(), BallSegmenter(30.0), monitor), Error);
}

TEST(Prepare, IsCancelledFromAnotherThread) {
  TaskMonitor* running = nullptr;
  TaskMonitor monitor([&](const std::string&, double) { running->cancel(); });
  running = &monitor;
  EXPECT_THROW(prepare(ballVolume(), BallSegmenter(kRadius_mm), BallSegmenter(30.0), monitor), Cancelled);
}

}  // namespace
}  // namespace facenav::steps
