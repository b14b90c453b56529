#include <gmock/gmock.h>

#include "facenav/evaluation/cross_section.h"
#include "facenav/evaluation/error_statistics.h"
#include "facenav/evaluation/html_report.h"
#include "facenav/evaluation/svg_plot.h"
#include "facenav/evaluation/tracking_evaluation.h"

namespace facenav::evaluation {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(ErrorStatistics, MatchesHandComputedValues) {
  const auto s = summarise({3, 4, 0, 5});
  EXPECT_EQ(s.count, 4);
  EXPECT_DOUBLE_EQ(s.mean, 3.0);
  EXPECT_DOUBLE_EQ(s.median, 3.5);
  EXPECT_DOUBLE_EQ(s.rms, std::sqrt(50.0 / 4));
  EXPECT_DOUBLE_EQ(s.p95, 5.0);
  EXPECT_DOUBLE_EQ(s.max, 5.0);
}

TEST(ErrorStatistics, OfNothingHasCountZero) { EXPECT_EQ(summarise({}).count, 0); }

TEST(TrackingEvaluation, CountsAWrongPoseCalledTracked) {
  std::map<std::int64_t, Eigen::Isometry3d> truth;
  for (int frame = 0; frame < 3; ++frame) truth[frame] = Eigen::Isometry3d::Identity();
  PoseEstimate good{0, true, Eigen::Isometry3d::Identity()}, lost{1, false, Eigen::Isometry3d::Identity()},
      wrong{2, true, {}};
  wrong.pose = Eigen::Translation3d(0, 0, 3.5) * Eigen::AngleAxisd(0.0, Eigen::Vector3d::UnitX());
  const auto result = evaluateTracking({good, lost, wrong}, truth, {10, 0, 0});
  EXPECT_EQ(result.tracked, 2);
  EXPECT_EQ(result.lost, 1);
  EXPECT_EQ(result.wrong_as_tracked, 1);
  EXPECT_NEAR(result.at_point_mm.max, 3.5, 1e-12);
}

TEST(TrackingEvaluation, RotationShowsAtThePointByItsLever) {
  const Eigen::Isometry3d turned(Eigen::AngleAxisd(0.01, Eigen::Vector3d::UnitZ()));
  const auto result =
      evaluateTracking({{7, true, turned}}, {{7, Eigen::Isometry3d::Identity()}}, {100, 0, 0});
  EXPECT_NEAR(result.at_point_mm.max, 2 * 100 * std::sin(0.005), 1e-9);
  EXPECT_NEAR(result.errors.at(0).rotation_about_deg.z(), 0.01 * 180 / M_PI, 1e-9);
}

TEST(SvgPlot, HoldsEachCurveAndEscapesItsText) {
  const std::string svg =
      svgPlot({"a < b", "x", "y"}, {{"ours", {{0, 1}, {1, 2}}}, {"paper", {{0, 5}, {1, 5}}, true, true}});
  EXPECT_THAT(svg, HasSubstr("a &lt; b"));
  EXPECT_THAT(svg, HasSubstr(">ours<"));
  EXPECT_THAT(svg, HasSubstr("stroke-dasharray"));
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
}

std::size_t countOf(const std::string& word, const std::string& text) {
  std::size_t count = 0;
  for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
  return count;
}

TEST(SvgPlot, ShowsEveryMarkHoweverMany) {
  Curve marks{"marks", {}, false};
  for (int i = 0; i < 500; ++i) marks.points.push_back({i, i % 7});
  EXPECT_EQ(countOf("<circle", svgPlot({"t", "x", "y"}, {marks})), 500u);
}

TEST(SvgPlot, WrapsALegendThatIsTooWide) {
  std::vector<Curve> curves(5, Curve{"patient, f 654 b 79, seed 21", {{0, 1}, {1, 2}}});
  const std::string svg = svgPlot({"t", "x", "y"}, curves);
  EXPECT_EQ(countOf("x='107'", svg), 3u) << "two names a line";
}

TEST(SvgPlot, OfNothingIsStillAPlot) { EXPECT_THAT(svgPlot({"t", "x", "y"}, {}), Not(HasSubstr("nan"))); }

TEST(HtmlReport, EscapesAndRefersToFigures) {
  const std::string html =
      htmlReport("T", "s", {{"H", "x < y", {{"", {"a"}, {{"1 & 2"}}}}, {{"cap", "f.png"}}}});
  EXPECT_THAT(html, HasSubstr("x &lt; y"));
  EXPECT_THAT(html, HasSubstr("1 &amp; 2"));
  EXPECT_THAT(html, HasSubstr("src=\"f.png\""));
}

TEST(CrossSection, DrawsThePointOnItsPlaceInRed) {
  volume::Volume mri;
  mri.grid.size = {20, 20, 20};
  mri.voxels.assign(mri.grid.count(), 0.f);
  mri.voxels[0] = 1.f;
  PointCloud<Mri> cloud;
  cloud.points_mm = {{5, 12, 8}, {3, 3, 15}};  // the second is 7 mm off the plane
  const cv::Mat picture =
      drawCrossSection(mri, volume::Anatomical::axial, Point<Mri>(0, 0, 8), cloud, {1.0, 4});
  const cv::Vec3b at_point = picture.at<cv::Vec3b>((19 - 12) * 4, (19 - 5) * 4),
                  off = picture.at<cv::Vec3b>((19 - 3) * 4, (19 - 3) * 4);
  EXPECT_GT(at_point[2], 200);
  EXPECT_LT(off[2], 60);
}

}  // namespace
}  // namespace facenav::evaluation
