#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "facenav/core/error.h"
#include "facenav/peers/bet_segmenter.h"
#include "facenav/segmentation/segmenter.h"
#include "head_phantom.h"

// Anything but a T1 MR of a head is refused in words, before a mask is made of it.

namespace facenav {
namespace {

using peers::makeBetSegmenter;
using segmentation::makeBrainSegmenter;
using testing::HeadPhantom;
using testing::makeHeadPhantom;
using testing::PhantomOptions;

std::string messageOf(const volume::Volume& volume, const segmentation::Segmenter& segmenter) {
  TaskMonitor monitor;
  try {
    segmenter.segment(volume, monitor);
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

const HeadPhantom& plainHead() {
  static const HeadPhantom head = makeHeadPhantom();
  return head;
}

/// Phantom in Hounsfield units: soft tissue 33 to 45, bone 900, air -1000.
HeadPhantom computedTomogram() {
  PhantomOptions quiet;
  quiet.noise = 0.005;
  HeadPhantom head = makeHeadPhantom(quiet);
  for (float& v : head.volume.voxels) v = v < 4 ? -1000.f : v < 16 ? 900.f : 30.f + 0.15f * v;
  return head;
}

TEST(BrainSegmenter, FindsTheBrainOfAComputedTomogramWithinItsSkullAndSaysSo) {
  HeadPhantom head = computedTomogram();
  for (const char* modality : {"CT", ""}) {  // a NIfTI does not give its modality
    head.volume.modality = modality;
    TaskMonitor monitor;
    const auto found = makeBrainSegmenter()->segment(head.volume, monitor);
    EXPECT_GT(volume::overlap(found.mask, head.brain).dice, 0.9) << modality;
    EXPECT_EQ(found.contrast, "CT");
    ASSERT_FALSE(found.warnings.empty());
    EXPECT_NE(found.warnings.back().find("this is a CT"), std::string::npos);
  }
  head.volume.modality = "CT";
  EXPECT_NE(messageOf(head.volume, *makeBetSegmenter()).find("no brain can be modelled: this is a CT"),
            std::string::npos);
}

TEST(BrainSegmenter, RefusesAComputedTomogramOfAPhantom) {
  HeadPhantom bottle = computedTomogram();  // water throughout, no skull
  bottle.volume.modality = "CT";
  for (float& v : bottle.volume.voxels)
    if (v > -500) v = 20;
  const std::string message = messageOf(bottle.volume, *makeBrainSegmenter());
  EXPECT_NE(message.find("no brain can be modelled"), std::string::npos) << message;
  EXPECT_NE(message.find("CT"), std::string::npos) << message;
}

TEST(BrainSegmenter, RefusesAComputedTomogramOfALeg) {
  volume::Volume leg;  // muscle, a bone in its middle
  leg.modality = "CT";
  leg.grid.size = {90, 90, 125};
  leg.grid.mri_from_voxel.linear() *= 2;
  for (int k = 0; k < 125; ++k)
    for (int j = 0; j < 90; ++j)
      for (int i = 0; i < 90; ++i) {
        const double r = 2 * std::hypot(i - 45.0, j - 45.0);
        leg.voxels.push_back(r < 8 ? 60.f : r < 16 ? 1100.f : r < 62 ? 55.f : r < 72 ? -90.f : -1000.f);
      }
  const std::string message = messageOf(leg, *makeBrainSegmenter());
  EXPECT_NE(message.find("no brain can be modelled"), std::string::npos) << message;
  EXPECT_NE(message.find("CT"), std::string::npos) << message;
}

TEST(BrainSegmenter, RefusesAComputedTomogramOfTheFaceAlone) {
  const HeadPhantom head = computedTomogram();
  volume::Volume face = head.volume;  // the front 60 mm
  const int first = face.grid.size[1] - 40;
  std::vector<float> voxels;
  for (int k = 0; k < face.grid.size[2]; ++k)
    for (int j = first; j < face.grid.size[1]; ++j)
      for (int i = 0; i < face.grid.size[0]; ++i) voxels.push_back(face.at(i, j, k));
  face.grid.mri_from_voxel.translate(Eigen::Vector3d(0, first, 0));
  face.grid.size[1] = 40, face.voxels = voxels, face.modality = "CT";
  const std::string message = messageOf(face, *makeBrainSegmenter());
  EXPECT_NE(message.find("no brain can be modelled"), std::string::npos) << message;
  EXPECT_NE(message.find("60 mm"), std::string::npos) << message;
}

TEST(BrainSegmenter, RefusesAHeadWithoutTissueContrast) {
  PhantomOptions flat;
  flat.has_tissue = false, flat.noise = 0.01;
  EXPECT_NE(messageOf(makeHeadPhantom(flat).volume, *makeBrainSegmenter()).find("no brain can be modelled"),
            std::string::npos);
}

TEST(BrainSegmenter, RefusesVolumesWithoutAHead) {
  volume::Volume volume = plainHead().volume;
  std::fill(volume.voxels.begin(), volume.voxels.end(), 7.f);
  EXPECT_NE(messageOf(volume, *makeBrainSegmenter()).find("no brain can be modelled"), std::string::npos);
  std::mt19937 random(3);
  for (float& v : volume.voxels) v = float(random() % 1000);
  EXPECT_NE(messageOf(volume, *makeBrainSegmenter()).find("no brain can be modelled"), std::string::npos);
}

TEST(BrainSegmenter, StopsWhenCancelled) {
  TaskMonitor monitor;
  monitor.cancel();
  EXPECT_THROW(makeBrainSegmenter()->segment(plainHead().volume, monitor), Cancelled);
}

}  // namespace
}  // namespace facenav
