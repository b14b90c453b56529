#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <random>

#include "checks/face_check.h"
#include "facenav/dicom/import_volume.h"
#include "facenav/segmentation/segmenter.h"
#include "facenav/surface/navigation_check.h"
#include "facenav/surface/scalp_surface.h"
#include "facenav/volume/nifti.h"
#include "facenav/volume/regrid.h"
#include "scalp/edge_width.h"
#include "support/test_data.h"

namespace facenav::surface {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using volume::Volume;

ScalpSurface scalpOf(const Volume& volume) {
  TaskMonitor monitor;
  return extractScalp(volume, segmentation::makeHeadSegmenter()->segment(volume, monitor).mask, monitor);
}

const Volume& virtualPatient() {
  static const Volume coarse = [] {
    const Volume full = volume::readNifti(facenav::testing::virtualPatientMri()).volume;
    return volume::resample(full, volume::isotropicGrid(full.grid, 1.5));
  }();
  return coarse;
}
const ScalpSurface& virtualPatientsScalp() {
  static const ScalpSurface scalp = scalpOf(virtualPatient());
  return scalp;
}

/// Sets voxels to 0 where `is_removed` is true for their position in Mri.
Volume without(Volume volume, const std::function<bool(const Eigen::Vector3d&)>& is_removed) {
  for (int k = 0; k < volume.grid.size[2]; ++k)
    for (int j = 0; j < volume.grid.size[1]; ++j)
      for (int i = 0; i < volume.grid.size[0]; ++i)
        if (is_removed(volume.grid.toMri({double(i), double(j), double(k)}).mm))
          volume.voxels[volume.grid.index(i, j, k)] = 0;
  return volume;
}

TEST(FaceCheck, FindsTheFaceOfAWholeHeadAndItsCutNoseTip) {
  FACENAV_NEEDS(facenav::testing::virtualPatientMri());
  const auto scalp = scalpOf(volume::readNifti(facenav::testing::virtualPatientMri()).volume);
  EXPECT_TRUE(scalp.has_face);
  EXPECT_THAT(scalp.findings, Contains(HasSubstr("nose tip is cut")));
  EXPECT_THAT(scalp.findings, Not(Contains(HasSubstr("scan ends"))));
}

TEST(FaceCheck, AcceptsAScanThatEndsAtMidNoseWithCaution) {
  FACENAV_NEEDS(facenav::testing::colin27());
  const auto scalp = scalpOf(volume::readNifti(facenav::testing::colin27()).volume);
  EXPECT_TRUE(scalp.has_face);
  EXPECT_THAT(scalp.findings, Contains(HasSubstr("scan ends at mid-nose")));
}

/// Removes everything below `z_mm` from the scan.
Volume endingAt(const Volume& scan, double z_mm) {
  const Volume whole = volume::toRasOrder(scan);
  Volume cut = whole;
  const int first = int(std::lround(
      whole.grid.toVoxel(Point<Mri>(whole.grid.centre().mm.x(), whole.grid.centre().mm.y(), z_mm)).z()));
  cut.grid.size[2] -= first;
  cut.grid.mri_from_voxel.translation() = whole.grid.toMri({0.0, 0.0, double(first)}).mm;
  cut.voxels.assign(whole.voxels.begin() + std::ptrdiff_t(whole.grid.index(0, 0, first)), whole.voxels.end());
  return cut;
}

TEST(FaceCheck, AcceptsScansThatEndBelowTheNose) {
  FACENAV_NEEDS(facenav::testing::virtualPatientMri());
  const Volume& whole = virtualPatient();
  double top = -1e9;
  for (const auto& v : virtualPatientsScalp().mesh.vertices_mm) top = std::max(top, v.z());
  const auto lip = scalpOf(endingAt(whole, top - 170));
  EXPECT_TRUE(lip.has_face);
  EXPECT_THAT(lip.findings, Contains(HasSubstr("scan ends at the upper lip")));
  const auto nose = scalpOf(endingAt(whole, top - 134));
  EXPECT_TRUE(nose.has_face);
  EXPECT_THAT(nose.findings, Contains(HasSubstr("scan ends at mid-nose")));
}

TEST(FaceCheck, SeesThatTheFaceWasCutAway) {
  FACENAV_NEEDS(facenav::testing::virtualPatientMri());
  const Volume& whole = virtualPatient();
  double top = -1e9, front = -1e9;
  for (const auto& v : virtualPatientsScalp().mesh.vertices_mm)
    top = std::max(top, v.z()), front = std::max(front, v.y());
  const double brow_z = top - 95;
  const auto box =
      scalpOf(without(whole, [&](const Eigen::Vector3d& p) { return p.z() < brow_z && p.y() > front - 65; }));
  EXPECT_FALSE(box.has_face) << "a box set to zero";
  EXPECT_FALSE(box.findings.empty());
  const auto shear = scalpOf(without(whole, [&](const Eigen::Vector3d& p) {
    return (p.y() - (front - 22)) + 0.55 * (brow_z - p.z()) > 0 && p.z() < brow_z + 30;
  }));
  EXPECT_FALSE(shear.has_face) << "sheared off by an oblique plane";
  const auto above = scalpOf(without(whole, [&](const Eigen::Vector3d& p) { return p.z() < brow_z + 5; }));
  EXPECT_FALSE(above.has_face) << "the scan ends at the brow";
}

/// The head lying too far in front: its foremost `beyond_mm` appear behind it, after 20 mm of air; slices of
/// 0 pad the scan at both ends.
Volume foldedNose(const Volume& scan, double beyond_mm) {
  constexpr double kAir_mm = 20, kPad_mm = 10;
  const Volume head = volume::toRasOrder(scan);
  const double voxel_mm = head.grid.spacing_mm().y();
  const int beyond = int(std::lround(beyond_mm / voxel_mm)), pad = int(kPad_mm / voxel_mm),
            behind = int((beyond_mm + kAir_mm) / voxel_mm), kept = head.grid.size[1] - beyond;
  Volume folded = head;
  folded.grid.size[1] = behind + kept + 2 * pad;
  folded.grid.mri_from_voxel.translation() = head.grid.toMri({0.0, -double(behind + pad), 0.0}).mm;
  folded.voxels.assign(folded.grid.count(), 0);
  for (int k = 0; k < head.grid.size[2]; ++k)
    for (int j = 0; j < behind + kept; ++j)
      for (int i = 0; i < head.grid.size[0]; ++i) {
        const float air = float((i * 7 + j * 13 + k * 5) % 5);
        folded.voxels[folded.grid.index(i, j + pad, k)] = j < beyond    ? head.at(i, kept + j, k)
                                                          : j >= behind ? head.at(i, j - behind, k)
                                                                        : air;
      }
  return folded;
}

TEST(FaceCheck, ANoseThatWrapsAroundIsCutAndItsPieceNamed) {
  FACENAV_NEEDS(facenav::testing::virtualPatientMri());
  const Volume folded = foldedNose(virtualPatient(), 15);
  TaskMonitor monitor;
  const auto mask = segmentation::makeHeadSegmenter()->segment(folded, monitor).mask;
  const auto scalp = extractScalp(folded, mask, monitor);
  EXPECT_THAT(scalp.findings, Contains(HasSubstr("nose tip is cut"))) << "also where the scan is padded";
  for (const auto& finding : checkForNavigation(folded, mask, scalp).findings)
    if (finding.topic == CheckTopic::wrap_around) {
      EXPECT_EQ(finding.verdict, Verdict::caution);
      EXPECT_THAT(finding.finding, HasSubstr("the back ("));
    }
}

/// The same head lying turned in the scanner: only the map to world coordinates changes.
Volume turned(Volume volume, double yaw_deg, double roll_deg) {
  const Eigen::Vector3d centre = volume.grid.centre().mm;
  const Eigen::Isometry3d turn =
      Eigen::Translation3d(centre) * Eigen::AngleAxisd(yaw_deg * M_PI / 180, Eigen::Vector3d::UnitZ()) *
      Eigen::AngleAxisd(roll_deg * M_PI / 180, Eigen::Vector3d::UnitY()) * Eigen::Translation3d(-centre);
  volume.grid.mri_from_voxel = turn * volume.grid.mri_from_voxel;
  return volume;
}

/// A function of the position in Mri: true in the face, in front of forehead and throat.
std::function<bool(const Eigen::Vector3d&)> inFace() {
  double top = -1e9, front = -1e9;
  for (const auto& v : virtualPatientsScalp().mesh.vertices_mm) top = std::max(top, v.z());
  for (const auto& v : virtualPatientsScalp().mesh.vertices_mm)
    if (v.z() > top - 95) front = std::max(front, v.y());
  return [=](const Eigen::Vector3d& p) { return p.z() < top - 85 && p.y() > front - 50; };
}

constexpr double kTurns_deg[][2] = {{10, 5}, {-15, 0}, {0, -10}};

TEST(FaceCheck, AcceptsAWholeFaceAtAnyTurnOfTheHead) {
  FACENAV_NEEDS(facenav::testing::virtualPatientMri());
  for (const auto& turn : kTurns_deg) {
    const auto scalp = scalpOf(turned(virtualPatient(), turn[0], turn[1]));
    EXPECT_TRUE(scalp.has_face) << turn[0] << " " << turn[1];
    EXPECT_THAT(scalp.findings, Not(Contains(HasSubstr("hard to make out"))));
  }
}

TEST(FaceCheck, AcceptsAFaceThatNodsAndEndsAtMidNose) {
  FACENAV_NEEDS(facenav::testing::virtualPatientMri());
  double top = -1e9;
  for (const auto& v : virtualPatientsScalp().mesh.vertices_mm) top = std::max(top, v.z());
  Volume scan = without(virtualPatient(), [&](const Eigen::Vector3d& p) { return p.z() < top - 140; });
  for (const double nod_deg : {-12.0, 12.0}) {
    Volume nodding = scan;
    nodding.grid.mri_from_voxel =
        Eigen::AngleAxisd(nod_deg * M_PI / 180, Eigen::Vector3d::UnitX()) * scan.grid.mri_from_voxel;
    EXPECT_TRUE(scalpOf(nodding).has_face) << nod_deg;
  }
}

TEST(FaceCheck, NamesARemovedOrNoisyFaceAtAnyTurnOfTheHead) {
  FACENAV_NEEDS(facenav::testing::virtualPatientMri());
  const auto in_face = inFace();
  const Volume zeroed = without(virtualPatient(), in_face);
  Volume noisy = zeroed;
  std::mt19937 random(5);
  std::normal_distribution<float> normal(0, 60);
  for (int k = 0; k < noisy.grid.size[2]; ++k)
    for (int j = 0; j < noisy.grid.size[1]; ++j)
      for (int i = 0; i < noisy.grid.size[0]; ++i)
        if (in_face(noisy.grid.toMri({double(i), double(j), double(k)}).mm))
          noisy.voxels[noisy.grid.index(i, j, k)] = std::abs(normal(random));
  // Each way meets two turns, and each turn meets one way.
  for (const auto& [defaced, which] : {std::pair(&zeroed, 0), {&zeroed, 1}, {&noisy, 1}, {&noisy, 2}}) {
    const auto& turn = kTurns_deg[which];
    const auto scalp = scalpOf(turned(*defaced, turn[0], turn[1]));
    EXPECT_FALSE(scalp.has_face) << turn[0] << " " << turn[1] << (defaced == &noisy ? " noise" : " zero");
    EXPECT_THAT(scalp.findings, Contains(HasSubstr("removed")));
  }
}

/// Blurs along one axis of the grid by a sampled Gaussian of three standard deviations. The outermost voxels
/// are thought to go on.
Volume blurredAlong(const Volume& volume, int axis, double sigma_voxels) {
  const int reach = int(std::ceil(3 * sigma_voxels)), length = volume.grid.size[axis];
  std::vector<float> weights;
  for (int d = -reach; d <= reach; ++d)
    weights.push_back(float(std::exp(-0.5 * d * d / (sigma_voxels * sigma_voxels))));
  const float sum = std::accumulate(weights.begin(), weights.end(), 0.0f);
  const auto& grid = volume.grid;
  const std::ptrdiff_t step = std::ptrdiff_t(axis == 0   ? 1
                                             : axis == 1 ? grid.index(0, 1, 0)
                                                         : grid.index(0, 0, 1));
  Volume blurred = volume;
  for (std::ptrdiff_t at = 0; at < std::ptrdiff_t(volume.voxels.size()); ++at) {
    const int place = int(at / step % length);
    float value = 0;
    for (int d = -reach; d <= reach; ++d) {
      const int there = std::clamp(place + d, 0, length - 1);
      value += weights[std::size_t(d + reach)] * volume.voxels[std::size_t(at + (there - place) * step)];
    }
    blurred.voxels[std::size_t(at)] = value / sum;
  }
  return blurred;
}

Volume gaussian(Volume volume, double sigma_mm) {
  const Eigen::Vector3d sigma = sigma_mm * volume.grid.spacing_mm().cwiseInverse();
  for (int axis = 0; axis < 3; ++axis) volume = blurredAlong(volume, axis, sigma[axis]);
  return volume;
}

TEST(FaceCheck, NamesABlurredFace) {
  FACENAV_NEEDS(facenav::testing::virtualPatientMri());
  const auto in_face = inFace();
  for (const double sigma_mm : {4.0, 7.0}) {
    Volume blurred = virtualPatient();
    const Volume smooth = gaussian(blurred, sigma_mm);
    for (int k = 0; k < blurred.grid.size[2]; ++k)
      for (int j = 0; j < blurred.grid.size[1]; ++j)
        for (int i = 0; i < blurred.grid.size[0]; ++i)
          if (in_face(blurred.grid.toMri({double(i), double(j), double(k)}).mm))
            blurred.voxels[blurred.grid.index(i, j, k)] = smooth.voxels[blurred.grid.index(i, j, k)];
    const auto scalp = scalpOf(turned(blurred, 8, -6));
    EXPECT_FALSE(scalp.has_face) << sigma_mm;
    EXPECT_THAT(scalp.findings, Contains(HasSubstr("blurred"))) << sigma_mm;
  }
}

TEST(FaceCheck, AFaceBeyondTheScansEdgeIsNotCalledDefaced) {
  FACENAV_NEEDS(facenav::testing::virtualPatientMri());
  const Volume whole = volume::toRasOrder(virtualPatient());
  double top = -1e9, forehead = -1e9;
  for (const auto& v : virtualPatientsScalp().mesh.vertices_mm) top = std::max(top, v.z());
  for (const auto& v : virtualPatientsScalp().mesh.vertices_mm)
    if (v.z() > top - 70) forehead = std::max(forehead, v.y());
  Volume cut = whole;  // without everything more than 20 mm behind the forehead's front
  cut.grid.size[1] = int(whole.grid.toVoxel(Point<Mri>(0, forehead - 20, 0)).y());
  cut.voxels.clear();
  for (int k = 0; k < cut.grid.size[2]; ++k)
    for (int j = 0; j < cut.grid.size[1]; ++j)
      for (int i = 0; i < cut.grid.size[0]; ++i)
        cut.voxels.push_back(whole.voxels[whole.grid.index(i, j, k)]);
  const auto scalp = scalpOf(cut);
  EXPECT_FALSE(scalp.has_face);
  EXPECT_THAT(scalp.findings, Contains(HasSubstr("edge cuts the face off")));
}

TEST(FaceCheck, AcceptsAWholeHeadOfAnotherScanner) {
  const auto folder = facenav::testing::sharedData() / "t1_philips";
  FACENAV_NEEDS(folder);
  TaskMonitor monitor;
  const Volume scan = dicom::importVolume(folder, std::nullopt, monitor).volume;
  for (const auto& turn : {std::pair(0.0, 0.0), std::pair(10.0, 5.0)}) {
    const auto scalp = scalpOf(turned(scan, turn.first, turn.second));
    EXPECT_TRUE(scalp.has_face) << turn.first;
    EXPECT_THAT(scalp.findings, Not(Contains(HasSubstr("hard to make out"))));
  }
}

TEST(FaceCheck, NamesTheRemovedFaceOfARealScan) {
  FACENAV_NEEDS(facenav::testing::t1Dicom());
  TaskMonitor monitor;
  const Volume fine = dicom::importVolume(facenav::testing::t1Dicom(), std::nullopt, monitor).volume;
  const auto scalp = scalpOf(volume::resample(fine, volume::isotropicGrid(fine.grid, 1.0)));
  EXPECT_FALSE(scalp.has_face);
  EXPECT_THAT(scalp.findings, Contains(HasSubstr("face was removed")));
}

/// Evidence of a clear face with one change.
FaceState stateOf(const std::function<void(FaceEvidence&)>& change) {
  FaceEvidence evidence;
  evidence.match = anatomy::FaceMatch{0.95, 1.0, 1.0, 0, 0, 1.0};
  evidence.detail = 4, evidence.edge_width = 1, evidence.height_mm = 220;
  change(evidence);
  return judgeFace(evidence);
}

TEST(JudgeFace, SaysWhatTheEvidenceShows) {
  using E = FaceEvidence;
  EXPECT_EQ(stateOf([](E&) {}), FaceState::whole);
  EXPECT_EQ(stateOf([](E& e) { e.match->likeness = 0.5; }), FaceState::removed);
  EXPECT_EQ(stateOf([](E& e) { e.match.reset(); }), FaceState::removed);
  EXPECT_EQ(stateOf([](E& e) { e.match.reset(), e.height_mm = 90; }), FaceState::not_in_scan);
  EXPECT_EQ(stateOf([](E& e) { e.match->likeness = 0.5, e.cut_mm = 80, e.cut_ahead_mm = -10; }),
            FaceState::cut_off);
  EXPECT_EQ(stateOf([](E& e) { e.match->likeness = 0.5, e.cut_mm = 80, e.cut_ahead_mm = 30; }),
            FaceState::removed)
      << "noise in front of the forehead, up to the scan's edge";
  EXPECT_EQ(stateOf([](E& e) { e.cut_mm = 80; }), FaceState::whole) << "a cap or a nose at the scan's edge";
  EXPECT_EQ(stateOf([](E& e) { e.edge_width = 3; }), FaceState::blurred);
  EXPECT_EQ(stateOf([](E& e) { e.detail = 1, e.match->strength = 0.4; }), FaceState::blurred);
}

TEST(JudgeFace, ADoubtfulFaceIsACautionNotARefusal) {
  using E = FaceEvidence;
  EXPECT_EQ(stateOf([](E& e) { e.match->likeness = 0.75; }), FaceState::unclear);
  EXPECT_EQ(stateOf([](E& e) { e.edge_width = 1.6; }), FaceState::unclear);
  EXPECT_EQ(stateOf([](E& e) { e.detail = 1; }), FaceState::unclear) << "smooth, but not flat";
  EXPECT_EQ(stateOf([](E& e) { e.match->strength = 0.4; }), FaceState::whole) << "flat, but not smooth";
  EXPECT_EQ(stateOf([](E& e) { e.detail.reset(), e.edge_width.reset(); }), FaceState::whole)
      << "not measurable";
}

TEST(EdgeWidth, IsThatOfTheBlur) {
  for (const double blur_mm : {1.0, 3.0}) {
    Volume slab;  // tissue of 100 below z = 0; the edge is a logistic step of slope 100 / (4 * blur)
    slab.grid.size = {5, 5, 61};
    slab.grid.mri_from_voxel.translation() = Eigen::Vector3d(-2, -2, -30);
    for (int k = 0; k < 61; ++k)
      for (int v = 0; v < 25; ++v) slab.voxels.push_back(float(100 / (1 + std::exp((k - 30) / blur_mm))));
    TriangleMesh mesh;
    mesh.vertices_mm = {{0, 0, 0}};
    mesh.normals = {{0, 0, 1}};
    const double step = 100 * (1 / (1 + std::exp(-5 / blur_mm)) - 1 / (1 + std::exp(6 / blur_mm)));
    EXPECT_NEAR(edgeWidth_mm(mesh, slab).at(0), step / (100 / (4 * blur_mm)), 0.12 * 4 * blur_mm) << blur_mm;
  }
}

}  // namespace
}  // namespace facenav::surface
