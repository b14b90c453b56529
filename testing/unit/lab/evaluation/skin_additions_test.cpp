// The skin of a real head stays in place with everything that a scanner may add beside it.

#include "facenav/evaluation/skin_additions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "facenav/segmentation/segmenter.h"
#include "facenav/surface/scalp_surface.h"
#include "facenav/surface/surface_distance.h"
#include "facenav/volume/mask_morphology.h"
#include "facenav/volume/nifti.h"
#include "support/test_data.h"

namespace facenav::evaluation {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

struct Skin {
  segmentation::SegmentationResult head;
  surface::ScalpSurface scalp;
};

Skin skinOf(const volume::Volume& scan) {
  TaskMonitor monitor;
  Skin skin{segmentation::makeHeadSegmenter()->segment(scan, monitor), {}};
  skin.scalp = surface::extractScalp(scan, skin.head.mask, monitor);
  return skin;
}

struct Moved {
  surface::SurfaceDistance beyond, contact;
};
Moved moved(const Skin& clean, const Skin& found, const volume::Mask& pads) {
  const auto moved_mm = surface::signedDistances_mm(clean.scalp.mesh, found.scalp.mesh);
  const auto pad_mm = volume::distanceTo(pads);
  std::vector<float> beyond, contact;
  for (std::size_t v = 0; v < moved_mm.size(); ++v) {
    const Eigen::Vector3i at =
        pads.grid.toVoxel(Point<Mri>(clean.scalp.mesh.vertices_mm[v])).array().round().cast<int>();
    const Eigen::Vector3i size(pads.grid.size[0], pads.grid.size[1], pads.grid.size[2]);
    if (at.minCoeff() < 8 || (size - at).minCoeff() < 9) continue;  // the scan's ends
    (pad_mm[pads.grid.index(at.x(), at.y(), at.z())] < 8 ? contact : beyond).push_back(moved_mm[v]);
  }
  return {surface::summarise(beyond), surface::summarise(contact)};
}

SkinAddition named(const std::string& name) {
  for (const auto& addition : skinAdditions())
    if (addition.name == name) return addition;
  throw std::runtime_error("no addition " + name);
}

TEST(SkinAdditions, APadBehindTheHeadIsLeftOutSaidAndDoubted) {
  FACENAV_NEEDS(facenav::testing::colin27());
  const auto scan = volume::readNifti(facenav::testing::colin27()).volume;
  const Skin clean = skinOf(scan);
  EXPECT_TRUE(clean.head.warnings.empty()) << clean.head.warnings.front();
  const CleanScan made(scan, clean.head.mask, clean.scalp.mesh);
  EXPECT_TRUE(made.isAirErased());
  const auto added = made.with(named("pad behind"), 7);
  EXPECT_GT(added.pads.volume_ml(), 100);
  const Skin found = skinOf(added.scan);
  EXPECT_THAT(found.head.warnings, Contains(HasSubstr("pads, earphones or haze that touch the head")));
  const Moved by = moved(clean, found, added.pads);
  EXPECT_LT(by.beyond.p95_mm, 0.1);
  EXPECT_LT(by.contact.median_mm, 0.3) << "7.4 mm with the pad taken for head";
  // The doubt is large where the pad lies, and only there.
  const auto under = [&](const Skin& skin) {
    const auto& vertices = skin.scalp.mesh.vertices_mm;
    const auto back = std::min_element(vertices.begin(), vertices.end(), [](const auto& a, const auto& b) {
      return a.y() + (a.z() < 0 ? 1e3 : 0) < b.y() + (b.z() < 0 ? 1e3 : 0);
    });
    return surface::skinDoubtUnder_mm(skin.scalp, Point<Mri>(*back));
  };
  EXPECT_GT(under(found), 2 * under(clean));
}

TEST(SkinAdditions, ATapeLiesOnTheForeheadAlone) {
  FACENAV_NEEDS(facenav::testing::colin27());
  const auto scan = volume::readNifti(facenav::testing::colin27()).volume;
  const Skin clean = skinOf(scan);
  const auto added = CleanScan(scan, clean.head.mask, clean.scalp.mesh).with(named("tape"), 7);
  EXPECT_GT(added.pads.volume_ml(), 1);
  EXPECT_LT(added.pads.volume_ml(), 5);
  const Moved by = moved(clean, skinOf(added.scan), added.pads);
  EXPECT_LT(by.beyond.p95_mm, 0.1) << "a tape moves no skin elsewhere";
  EXPECT_LT(std::abs(by.contact.median_mm), 0.6) << "less than the tape is thick";
}

TEST(SkinAdditions, ABrightNoseMovesNoSkin) {
  FACENAV_NEEDS(facenav::testing::colin27());
  const auto scan = volume::readNifti(facenav::testing::colin27()).volume;
  const Skin clean = skinOf(scan);
  const auto added =
      CleanScan(scan, clean.head.mask, clean.scalp.mesh).with(named("nose twice as bright"), 7);
  const Moved by = moved(clean, skinOf(added.scan), added.pads);
  EXPECT_LT(by.beyond.median_mm, 0.02);
  EXPECT_LT(by.beyond.p95_mm, 0.1) << "0.16 mm with one threshold for the whole head";
}

}  // namespace
}  // namespace facenav::evaluation
