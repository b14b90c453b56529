#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <opencv2/objdetect.hpp>

#include "egg_patient.h"
#include "facenav/core/error.h"
#include "facenav/room/synthetic_source.h"
#include "facenav/volume/nifti.h"
#include "patient/landmarks.h"
#include "support/test_data.h"

namespace facenav::room {
namespace {

VirtualPatient patientFrom(const std::filesystem::path& nifti) {
  TaskMonitor monitor;
  return makePatient(volume::readNifti(nifti).volume, {}, monitor);
}

/// Triangle edges without a triangle on the other side (directed edges).
int openEdges(const surface::TriangleMesh& mesh) {
  std::map<std::pair<int, int>, int> balance;
  for (const auto& t : mesh.triangles)
    for (int c = 0; c < 3; ++c) {
      const int from = t[c], to = t[(c + 1) % 3];
      balance[{std::min(from, to), std::max(from, to)}] += from < to ? 1 : -1;
    }
  return int(
      std::count_if(balance.begin(), balance.end(), [](const auto& edge) { return edge.second != 0; }));
}

TEST(VirtualPatient, HasAClosedSkinHairAndAFaceThatDetectorsFindInBothCameras) {
  FACENAV_NEEDS(testing::virtualPatientMri());
  const auto patient = std::make_shared<const VirtualPatient>(patientFrom(testing::virtualPatientMri()));
  EXPECT_EQ(openEdges(patient->skin), 0);
  double thinnest = 1e9, thickest = 0.0;
  for (std::size_t i = 0; i < patient->hair.size(); ++i) {
    const double rise_mm = (patient->visible.vertices_mm[i] - patient->skin.vertices_mm[i]).norm();
    thickest = std::max(thickest, rise_mm);
    if (patient->skin.vertices_mm[i].z() > patient->head_centre.mm.z() + 85.0)
      thinnest = std::min(thinnest, rise_mm);
  }
  EXPECT_GE(thinnest, 2.0 - 1e-6) << "on the crown";
  EXPECT_LE(thickest, 5.0 + 1e-6);
  ASSERT_EQ(patient->landmarks68_mm.size(), 68u);
  EXPECT_GT(patient->landmarks68_mm[36].x(), patient->landmarks68_mm[45].x() + 60.0)
      << "right eye at +x: not mirrored";

  ScenarioOptions options;
  options.name = "still";
  SyntheticSource source(options, patient);
  const auto frame = source.next();
  const auto rig = source.rig();
  const auto camera_T_mri = source.truth().camera_T_mri;
  EXPECT_GT(source.truth().face_visible_fraction, 0.9);
  for (const bool is_right : {false, true}) {
    const auto points =
        findPortraitLandmarks(is_right ? frame->right : frame->left);  // Haar cascade, then dlib
    ASSERT_TRUE(points) << (is_right ? "right" : "left");
    double sum_px = 0.0;
    for (int i = 17; i < 68; ++i) {
      Eigen::Vector3d p = (camera_T_mri * Point<Mri>(patient->landmarks68_mm[std::size_t(i)])).mm;
      if (is_right) p = rig.right_T_left.isometry() * p;
      sum_px +=
          (cameras::project(is_right ? rig.right : rig.left, p) - (*points)[std::size_t(i)]).norm() / 51.0;
    }
    EXPECT_LT(sum_px, 6.0);
  }
}

TEST(VirtualPatient, Colin27IsCutAtMidNoseAndStillStands) {
  FACENAV_NEEDS(testing::colin27());
  const auto patient = patientFrom(testing::colin27());
  EXPECT_EQ(openEdges(patient.skin), 0);
  EXPECT_NEAR(patient.skin.vertices_mm.size(), 200000, 100000);
}

TEST(VirtualPatient, AnEmptyVolumeIsNoPatient) {
  volume::Volume empty;
  empty.grid.size = {40, 40, 40};
  empty.voxels.assign(empty.grid.count(), 0.f);
  TaskMonitor monitor;
  EXPECT_THROW(makePatient(empty, {}, monitor), Error);
}

}  // namespace
}  // namespace facenav::room
