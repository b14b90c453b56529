#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>

#include "facenav/core/error.h"
#include "facenav/segmentation/segmenter.h"
#include "head_phantom.h"

// What is no T1 MR of a head is refused in words, before a mask is made of it.

namespace facenav {
namespace {

using segmentation::makeBetSegmenter;
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

TEST(BrainSegmenter, RefusesAComputedTomogramInWords) {
  HeadPhantom head = plainHead();
  head.volume.modality = "CT";
  EXPECT_NE(messageOf(head.volume, *makeBrainSegmenter()).find("no brain can be modelled: this is a CT"),
            std::string::npos);
  EXPECT_NE(messageOf(head.volume, *makeBetSegmenter()).find("no brain can be modelled: this is a CT"),
            std::string::npos);
}

TEST(BrainSegmenter, RefusesAHeadWithoutTissueContrast) {
  PhantomOptions flat;
  flat.has_tissue = false, flat.noise = 0.01;
  EXPECT_NE(messageOf(makeHeadPhantom(flat).volume, *makeBrainSegmenter()).find("no brain can be modelled"),
            std::string::npos);
}

TEST(BrainSegmenter, RefusesAComputedTomogramWithoutItsModality) {
  PhantomOptions quiet;
  quiet.noise = 0.005;
  HeadPhantom head =
      makeHeadPhantom(quiet);  // to Hounsfield units: soft tissue 33 to 45, bone 900, air -1000
  for (float& v : head.volume.voxels) v = v < 4 ? -1000.f : v < 16 ? 900.f : 30.f + 0.15f * v;
  for (const auto& segmenter : {makeBrainSegmenter(), makeBetSegmenter()})
    EXPECT_NE(messageOf(head.volume, *segmenter).find("no brain can be modelled"), std::string::npos);
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
