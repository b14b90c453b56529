#include "facenav/guidance/eeg_sites.h"

#include <gmock/gmock.h>

#include "facenav/core/error.h"
#include "made_targets.h"
#include "support/matchers.h"

namespace facenav::guidance {
namespace {
using facenav::testing::EigenNear;
using surface::Landmark;

constexpr double kEegBall_mm = 90;
const Eigen::Vector3d kEegCentre_mm(5, -8, 12);

const surface::ScalpPaths& eegPaths() {
  static const surface::ScalpPaths kPaths(testing::sphere(kEegCentre_mm, kEegBall_mm, 120));
  return kPaths;
}

/// Landmarks on a ball at its equator, as on the flat map of the textbooks.
surface::ScalpLandmarks equator(double sd_mm = 2) {
  surface::ScalpLandmarks landmarks;
  const auto put = [&](Landmark which, const Eigen::Vector3d& direction) {
    landmarks[which] = surface::ScalpLandmark{Point<Mri>(kEegCentre_mm + kEegBall_mm * direction),
                                              sd_mm,
                                              surface::LandmarkSource::skin,
                                              false,
                                              {},
                                              {}};
  };
  put(Landmark::nasion, {0, 1, 0});
  put(Landmark::inion, {0, -1, 0});
  put(Landmark::tragus_left, {-1, 0, 0});
  put(Landmark::tragus_right, {1, 0, 0});
  return landmarks;
}

Eigen::Vector3d directionOf(const EegSites& sites, const std::string& name) {
  return (sites.find(name).point.mm - kEegCentre_mm) / kEegBall_mm;
}
Eigen::Vector3d polar(double from_top_deg, double from_front_deg) {  // to the patient's left
  const double t = testing::rad(from_top_deg), f = testing::rad(from_front_deg);
  return {-std::sin(t) * std::sin(f), std::sin(t) * std::cos(f), std::cos(t)};
}

TEST(EegSites, LieOnABallWhereTheTextbookPutsThem) {
  const EegSites sites = placeEegSites(eegPaths(), equator());
  const struct {
    const char* name;
    double from_top_deg, from_front_deg;
  } expected[] = {{"Cz", 0, 0},     {"Fz", 36, 0},   {"Fpz", 72, 0},  {"Pz", 36, 180},  {"Oz", 72, 180},
                  {"C3", 36, 90},   {"T7", 72, 90},  {"C4", 36, -90}, {"T8", 72, -90},  {"Fp1", 72, 18},
                  {"F7", 72, 54},   {"P7", 72, 126}, {"O1", 72, 162}, {"Fp2", 72, -18}, {"F8", 72, -54},
                  {"P8", 72, -126}, {"O2", 72, -162}};
  for (const auto& site : expected)
    EXPECT_THAT(directionOf(sites, site.name),
                EigenNear(polar(site.from_top_deg, site.from_front_deg), 0.006))
        << site.name;
  EXPECT_NEAR(sites.nasion_inion_mm, M_PI * kEegBall_mm, 0.3);
  EXPECT_NEAR(sites.tragus_tragus_mm, M_PI * kEegBall_mm, 0.3);
  EXPECT_NEAR(sites.circumference_mm, 2 * M_PI * kEegBall_mm * std::sin(testing::rad(72)), 0.8);
}

TEST(EegSites, F3IsHalfwayFromFzToF7InTheirPlane) {
  const EegSites sites = placeEegSites(eegPaths(), equator());
  for (const auto& [half, middle, end] :
       {std::tuple("F3", "Fz", "F7"), std::tuple("F4", "Fz", "F8"), std::tuple("P3", "Pz", "P7")}) {
    const Eigen::Vector3d a = directionOf(sites, middle), b = directionOf(sites, end),
                          f = directionOf(sites, half);
    EXPECT_NEAR((f - a).norm(), (f - b).norm(), 0.01) << half;
    const Eigen::Vector3d other = directionOf(sites, std::string(end) == "F7"   ? "F8"
                                                     : std::string(end) == "F8" ? "F7"
                                                                                : "P8");
    const Eigen::Vector3d normal = (b - a).cross(other - a).normalized();
    EXPECT_NEAR(normal.dot(f - a), 0.0, 0.005) << half << " lies in the plane of " << middle;
  }
}

TEST(EegSites, KnowsOldNamesAndListsItsOwn) {
  const EegSites sites = placeEegSites(eegPaths(), equator());
  EXPECT_EQ(sites.find("T3").name, "T7");
  EXPECT_EQ(sites.find("t6").name, "P8");
  EXPECT_EQ(sites.find("fp1").name, "Fp1");
  EXPECT_EQ(sites.sites.size(), 21u);
  try {
    sites.find("Q9");
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("Fpz, Fp1"));
  }
}

TEST(EegSites, ALandmarkMovedByItsErrorMovesTheSitesByTheirs) {
  surface::ScalpLandmarks landmarks = equator(0);
  landmarks[Landmark::inion]->sd_mm = 6;
  const EegSites sites = placeEegSitesWithErrors(eegPaths(), landmarks);
  // An error of 6 mm upwards moves Oz by 0.9 of that and Cz by half; one aside hardly moves Cz.
  EXPECT_NEAR(sites.find("Cz").sd_mm, 3.0, 1.0);
  EXPECT_GT(sites.find("Oz").sd_mm, 5.0);
  EXPECT_LT(sites.find("Fpz").sd_mm, 1.5);
}

TEST(EegSites, SayHowToSetALandmarkThatIsNotKnown) {
  surface::ScalpLandmarks landmarks = equator();
  landmarks[Landmark::inion].reset();
  try {
    placeEegSites(eegPaths(), landmarks);
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("the inion is not known"));
  }
}

}  // namespace
}  // namespace facenav::guidance
