#include "facenav/guidance/beam_f3.h"

#include <gtest/gtest.h>

#include "facenav/core/error.h"
#include "made_targets.h"

namespace facenav::guidance {
namespace {

TEST(BeamF3, GivesWhatTheCalculatorThatClinicsUseGives) {
  // If both arcs are equal, users of the calculator found its output linear: 0.1154 times the circumference
  // and 0.2637 times the arc.
  for (const double arc_mm : {320.0, 350.0, 380.0}) {
    const BeamF3Lengths lengths = beamF3Lengths(arc_mm, arc_mm, 560);
    EXPECT_NEAR(lengths.x_mm, 0.1154 * 560, 0.1);
    EXPECT_NEAR(lengths.y_mm, 0.2637 * arc_mm, 0.1);
  }
}

TEST(BeamF3, ALongerHeadMovesItAwayFromTheVertexAndAWiderGirthFromTheMidline) {
  const BeamF3Lengths round = beamF3Lengths(360, 360, 570);
  EXPECT_GT(beamF3Lengths(380, 360, 570).y_mm, round.y_mm + 1);
  EXPECT_NEAR(beamF3Lengths(360, 360, 600).x_mm / round.x_mm, 600.0 / 570, 1e-9);
  EXPECT_NEAR(beamF3Lengths(360, 360, 600).y_mm, round.y_mm, 1e-9);
}

TEST(BeamF3, RefusesMeasuresOfNoHead) {
  EXPECT_THROW(beamF3Lengths(36, 36, 57), Error);  // centimetres
  EXPECT_THROW(beamF3Lengths(360, 360, 1e4), Error);
}

TEST(BeamF3, LiesAtItsLengthsOnABall) {
  constexpr double kRadius_mm = 90;
  const auto mesh = testing::sphere(Eigen::Vector3d(5, -8, 12), kRadius_mm, 120);
  const surface::ScalpPaths paths(mesh);
  surface::ScalpLandmarks landmarks;
  const auto put = [&](surface::Landmark which, const Eigen::Vector3d& direction) {
    landmarks[which] = surface::ScalpLandmark{
        Point<Mri>(Eigen::Vector3d(5, -8, 12) + kRadius_mm * direction.normalized()), 1, {}, false, {}, {}};
  };
  put(surface::Landmark::nasion, {0, 1, -0.25});
  put(surface::Landmark::inion, {0, -1, -0.25});
  put(surface::Landmark::tragus_left, {-1, 0, -0.25});
  put(surface::Landmark::tragus_right, {1, 0, -0.25});
  const EegSites sites = placeEegSites(paths, landmarks);
  const BeamF3 beam = placeBeamF3(paths, sites);
  // On a ball: angle round the vertical by x over the circumference, angle from the top by y over the radius.
  const Eigen::Vector3d out = (beam.point.mm - Eigen::Vector3d(5, -8, 12)) / kRadius_mm;
  const double from_top_rad = std::acos(out.z()), from_front_rad = std::atan2(-out.x(), out.y());
  EXPECT_NEAR(from_top_rad * kRadius_mm, beam.lengths.y_mm, 0.5);
  EXPECT_NEAR(from_front_rad / (2 * M_PI), beam.lengths.x_mm / sites.circumference_mm, 0.002);
  EXPECT_LT(out.x(), 0) << "on the patient's left";
  EXPECT_GT(out.y(), 0) << "in front of the vertex";
  const BeamF3 right = placeBeamF3(paths, sites, Side::right);
  const Eigen::Vector3d mirrored = (right.point.mm - Eigen::Vector3d(5, -8, 12)) / kRadius_mm;
  EXPECT_LT((mirrored - Eigen::Vector3d(-out.x(), out.y(), out.z())).norm() * kRadius_mm, 0.5) << "F4";
}

}  // namespace
}  // namespace facenav::guidance
