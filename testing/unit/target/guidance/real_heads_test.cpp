// Two real heads: EEG sites against published positions, the coil's plate at 200 places, the grid.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

#include "facenav/core/error.h"
#include "facenav/guidance/beam_f3.h"
#include "facenav/guidance/coil_plate.h"
#include "facenav/guidance/target_grid.h"
#include "facenav/segmentation/segmenter.h"
#include "facenav/volume/nifti.h"
#include "support/test_data.h"

namespace facenav::guidance {
namespace {

using Eigen::Vector3d;
using surface::Landmark;

surface::ScalpSurface scalpOf(const std::filesystem::path& nifti) {
  TaskMonitor monitor;
  const auto mri = volume::readNifti(nifti).volume;
  return surface::extractScalp(mri, segmentation::makeHeadSegmenter()->segment(mri, monitor).mask, monitor);
}
const surface::ScalpSurface& colin() {
  static const auto kScalp = scalpOf(facenav::testing::colin27());
  return kScalp;
}
const surface::ScalpSurface& wholeFace() {
  static const auto kScalp = scalpOf(facenav::testing::virtualPatientMri());
  return kScalp;
}

/// Nz, Iz, LPA, RPA of the standard 10-05 positions, which were measured on Colin27's scalp
/// (standard_1005.elc, Oostenveld and Praamstra 2001); MNI mm.
surface::ScalpLandmarks publishedLandmarks() {
  const surface::ScalpPaths paths(colin().mesh);
  surface::ScalpLandmarks landmarks;
  const auto put = [&](Landmark which, const Vector3d& p) {
    landmarks[which] = surface::ScalpLandmark{paths.onSkin(p).point, 1, {}, false, {}, {}};
  };
  put(Landmark::nasion, {0.0083, 86.8110, -39.9830});
  put(Landmark::inion, {0.0045, -118.5650, -23.0780});
  put(Landmark::tragus_left, {-86.0761, -19.9897, -47.9860});
  put(Landmark::tragus_right, {85.7939, -20.0093, -48.0310});
  return landmarks;
}

TEST(EegSitesOnColin27, LieWithinFiveMillimetresOfThePublishedOnesOnAverage) {
  FACENAV_NEEDS(facenav::testing::colin27());
  const std::map<std::string, Vector3d> published{
      {"Fp1", {-29.4367, 83.9171, -6.9900}}, {"F7", {-70.2629, 42.4743, -11.4200}},
      {"F3", {-50.2438, 53.1112, 42.1920}},  {"Fz", {0.3122, 58.5120, 66.4620}},
      {"F4", {51.8362, 54.3048, 40.8140}},   {"C3", {-65.3581, -11.6317, 64.3580}},
      {"Cz", {0.4009, -9.1670, 100.2440}},   {"C4", {67.1179, -10.9003, 63.5800}},
      {"T7", {-84.1611, -16.0187, -9.3460}}, {"P3", {-53.0073, -78.7878, 55.9400}},
      {"Pz", {0.3247, -81.1150, 82.6150}},   {"Oz", {0.1076, -114.8920, 14.6570}}};
  const EegSites sites = placeEegSites(surface::ScalpPaths(colin().mesh), publishedLandmarks());
  double sum_mm = 0;
  for (const auto& [name, place] : published) {
    const double off_mm = (sites.find(name).point.mm - place).norm();
    std::printf("%-4s %5.1f mm from the published place (%.1f %.1f %.1f)\n", name.c_str(), off_mm,
                sites.find(name).point.mm.x(), sites.find(name).point.mm.y(), sites.find(name).point.mm.z());
    EXPECT_LT(off_mm, 10) << name;
    sum_mm += off_mm / double(published.size());
  }
  std::printf("mean %.1f mm\n", sum_mm);
  EXPECT_LT(sum_mm, 5);
}

/// First point of Colin27's brain under a site of the scalp, along the line to a point inside the head.
Vector3d underSite(const volume::Volume& brain, const Vector3d& site_mm) {
  const Vector3d inside(0, -20, 10), step = 0.25 * (inside - site_mm).normalized();
  for (Vector3d p = site_mm; (p - inside).norm() > 1; p += step)
    if (volume::sampleLinear(brain, brain.grid.toVoxel(Point<Mri>(p))) > 20) return p;
  return inside;
}

TEST(EegSitesOnColin27, ProjectOntoTheCortexWherePeopleHaveThem) {
  FACENAV_NEEDS(facenav::testing::colin27());
  // Okamoto et al. 2004, Neuroimage 21:99-111, means of 17 adults; their spread is 4 to 9 mm in each
  // direction.
  const std::map<std::string, Vector3d> published{{"F3", {-35.5, 49.4, 32.4}}, {"C3", {-52.2, -16.4, 57.8}},
                                                  {"Cz", {0.8, -14.7, 73.9}},  {"C4", {54.1, -18.0, 57.5}},
                                                  {"F4", {40.2, 47.6, 32.1}},  {"Pz", {0.2, -62.1, 64.5}}};
  const auto brain = volume::readNifti(facenav::testing::colin27Brain()).volume;
  const surface::ScalpPaths paths(colin().mesh);
  const EegSites sites = placeEegSites(paths, publishedLandmarks());
  for (const auto& [name, place] : published) {
    const Vector3d cortex = underSite(brain, sites.find(name).point.mm);
    std::printf("%-4s cortex %.1f %.1f %.1f: %.1f mm from the published mean\n", name.c_str(), cortex.x(),
                cortex.y(), cortex.z(), (cortex - place).norm());
    EXPECT_LT((cortex - place).norm(), 20) << name;
  }
  const BeamF3 beam = placeBeamF3(paths, sites);
  const Vector3d cortex = underSite(brain, beam.point.mm);
  std::printf("Beam F3: NI %.0f, TT %.0f, circumference %.0f -> x %.1f, y %.1f mm; cortex %.1f %.1f %.1f\n",
              sites.nasion_inion_mm, sites.tragus_tragus_mm, sites.circumference_mm, beam.lengths.x_mm,
              beam.lengths.y_mm, cortex.x(), cortex.y(), cortex.z());
  EXPECT_LT((beam.point.mm - sites.find("F3").point.mm).norm(), 25);
}

/// Tests for a point inside the outline, independently of the module: even-odd rule.
bool lies(const std::vector<Eigen::Vector2d>& outline, double x, double y) {
  bool is_in = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const auto &a = outline[i], &b = outline[(i + 1) % outline.size()];
    if ((a.y() <= y) != (b.y() <= y) && x < a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
      is_in = !is_in;
  }
  return is_in;
}

struct Standing {
  double through_mm = -1e300;  // the highest vertex over the plate's plane within the outline
  double tilt_deg = 0, lift_mm = 0;
};
Standing standingOf(const Target& target, const surface::ScalpSurface& scalp, const CoilPlate& plate) {
  Standing standing;
  const auto coil_T_mri = target.mri_T_target.inverse();
  for (const Vector3d& v : scalp.mesh.vertices_mm) {
    const Vector3d q = (coil_T_mri * Point<Mri>(v)).mm;
    if (q.z() < 60 && lies(plate.outline_mm, q.x(), q.y()))
      standing.through_mm = std::max(standing.through_mm, -q.z());
  }
  const PlateContact contact = contactOf(target, scalp, plate);
  standing.tilt_deg = contact.tilt_rad * 180 / M_PI;
  standing.lift_mm = contact.lift_mm;
  return standing;
}

/// Rests the coil at 200 random places above the ears and reports its contact.
void restEverywhere(const surface::ScalpSurface& scalp, double lowest_z_mm) {
  const CoilPlate plate = figureOfEight();
  std::mt19937 random(11);
  std::uniform_int_distribution<std::size_t> any(0, scalp.mesh.vertices_mm.size() - 1);
  std::uniform_real_distribution<double> angle(-M_PI, M_PI), depth(12, 30);
  std::vector<double> tilts, lifts, highs;
  int refused = 0;
  for (int made = 0; made < 200;) {
    const std::size_t v = any(random);
    const Vector3d skin = scalp.mesh.vertices_mm[v];
    if (skin.z() < lowest_z_mm) continue;
    ++made;
    const Point<Mri> cortex(skin - depth(random) * scalp.mesh.normals[v]);
    Target target;
    try {
      target = restOnHead(planTarget("t", scalp, cortex, angle(random)), scalp, plate);
    } catch (const Error&) {
      ++refused;
      continue;
    }
    const Standing standing = standingOf(target, scalp, plate);
    highs.push_back(standing.through_mm);
    tilts.push_back(standing.tilt_deg);
    lifts.push_back(standing.lift_mm);
    EXPECT_LE(standing.through_mm, 0.05) << "skin through the plate at " << skin.transpose();
    EXPECT_GE(standing.through_mm, -0.25) << "no vertex near the plate at " << skin.transpose();
  }
  for (auto* list : {&highs, &tilts, &lifts}) std::sort(list->begin(), list->end());
  const auto at = [](const std::vector<double>& list, double part) {
    return list[std::size_t(part * double(list.size() - 1))];
  };
  std::printf(
      "%zu rested, %d refused; highest vertex %.3f to %.3f mm; tilt median %.1f, 95 %% %.1f, most %.1f "
      "deg; lift median %.2f, 95 %% %.1f, most %.1f mm\n",
      highs.size(), refused, highs.front(), highs.back(), at(tilts, 0.5), at(tilts, 0.95), tilts.back(),
      at(lifts, 0.5), at(lifts, 0.95), lifts.back());
  EXPECT_LE(refused, 4);
}

TEST(CoilPlateOnColin27, NeverPassesThroughTheSkinAndAlwaysTouchesIt) {
  FACENAV_NEEDS(facenav::testing::colin27());
  restEverywhere(colin(), -25);
}

TEST(CoilPlateOnAHeadWithEars, NeverPassesThroughTheSkinAndAlwaysTouchesIt) {
  FACENAV_NEEDS(facenav::testing::virtualPatientMri());
  restEverywhere(wholeFace(), -10);
}

TEST(TargetGridOnColin27, KeepsItsSpacingAlongTheScalp) {
  FACENAV_NEEDS(facenav::testing::colin27());
  const surface::ScalpPaths paths(colin().mesh);
  const Target seed =
      restOnHead(planTarget("M1", colin(), Point<Mri>(-37, -21, 58), M_PI / 4), colin(), figureOfEight());
  const GridSpec spec{7, 7, 7.5, GridOn::scalp};
  const auto points = gridRound(paths, colin().mesh, seed.scalp_point.mm, seed.mri_T_target.rotation(), spec);
  double worst_row_mm = 0, worst_column_mm = 0;
  for (int i = 0; i < 49; ++i) {
    const auto along = [&](int j) {
      return paths.shortest(points[std::size_t(i)].place_mm, points[std::size_t(j)].place_mm).length_mm() -
             7.5;
    };
    if (i % 7 < 6) worst_row_mm = std::max(worst_row_mm, std::abs(along(i + 1)));
    if (i < 42) worst_column_mm = std::max(worst_column_mm, std::abs(along(i + 7)));
  }
  std::printf("spacing 7.5 mm: worst error %.2f mm along the rows, %.2f mm between rows\n", worst_row_mm,
              worst_column_mm);
  EXPECT_LT(worst_row_mm, 0.5);
  EXPECT_LT(worst_column_mm, 1.2) << "22.5 mm beside the middle column the curvature alone takes 0.3 mm";
}

}  // namespace
}  // namespace facenav::guidance
