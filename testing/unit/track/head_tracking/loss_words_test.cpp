// The reasons of a loss, and the sharpness that determines them.

#include "head/loss_words.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "head/fine_detail.h"

namespace facenav::head_tracking {
namespace {

const Eigen::Vector3d kFaceCentre(0, 0, 600);
const cv::Rect kFace(20, 20, 160, 120);

cv::Mat texture() {
  cv::RNG random(std::uint64_t(4));
  cv::Mat1f image(160, 200);
  random.fill(image, cv::RNG::NORMAL, 120, 60);
  cv::GaussianBlur(image, image, {}, 1.2);
  cv::Mat out;
  image.convertTo(out, CV_8U);
  return out;
}

Eigen::Isometry3d movedBy(double back_mm) { return Eigen::Isometry3d(Eigen::Translation3d(0, 0, back_mm)); }

TEST(FineDetail, FallsWithBlurAndNotWithTheLight) {
  const cv::Mat sharp = texture();
  const double detail = *fineDetail(ImagePyramid(sharp), kFace, 0);
  double last = detail;
  for (const double sigma_px : {1.5, 3.0, 5.0}) {
    cv::Mat blurred;
    cv::GaussianBlur(sharp, blurred, {}, sigma_px);
    const double here = *fineDetail(ImagePyramid(blurred), kFace, 0);
    EXPECT_LT(here, last) << sigma_px;
    last = here;
  }
  cv::Mat darker;
  sharp.convertTo(darker, CV_8U, 0.5, 20);
  EXPECT_NEAR(*fineDetail(ImagePyramid(darker), kFace, 0), detail, 0.02 * detail);
}

TEST(FineDetail, OfABoxThatIsTooSmallOrOutsideIsNotKnown) {
  const ImagePyramid image(texture());
  EXPECT_FALSE(fineDetail(image, {20, 20, 18, 18}, 0));
  EXPECT_FALSE(fineDetail(image, {400, 20, 100, 100}, 0));
  EXPECT_TRUE(fineDetail(image, {150, 100, 100, 100}, 0)) << "what of it lies inside";
}

TEST(LossWords, AHeadThatWalkedAwayIsTooFarAndOneThatWasNearIsNot) {
  const LossWords words(kFaceCentre, 0, ImagePyramid(texture()), kFace);
  HeadMotion unknown(kFaceCentre), near(kFaceCentre), far(kFaceCentre);
  near.add(movedBy(0), {10}), far.add(movedBy(300), {10});
  EXPECT_TRUE(words.isFar(movedBy(400), unknown, {10}));
  EXPECT_FALSE(words.isFar(movedBy(300), unknown, {10})) << "900 of 960 mm";
  EXPECT_FALSE(words.isFar(movedBy(400), near, {10.05})) << "nobody walks 400 mm in 50 ms";
  EXPECT_TRUE(words.isFar(movedBy(400), near, {10.3}));
  EXPECT_TRUE(words.isFar(movedBy(400), far, {10.05}));
}

TEST(LossWords, NameBlurAndDistanceAndNothingElse) {
  const cv::Mat sharp = texture();
  const ImagePyramid image(sharp);
  const LossWords words(kFaceCentre, 0, image, kFace);
  const HeadMotion unknown(kFaceCentre);
  EXPECT_FALSE(words.circumstance(movedBy(0), image, kFace, unknown, {1}));
  cv::Mat blurred;
  cv::GaussianBlur(sharp, blurred, {}, 5);
  EXPECT_EQ(words.circumstance(movedBy(0), ImagePyramid(blurred), kFace, unknown, {1}), LossDetail::blurred);
  EXPECT_EQ(words.circumstance(movedBy(500), ImagePyramid(blurred), kFace, unknown, {1}),
            LossDetail::too_far);
  EXPECT_FALSE(words.circumstance(movedBy(0), ImagePyramid(blurred), {500, 0, 50, 50}, unknown, {1}))
      << "a face outside the picture says nothing of its sharpness";
}

TEST(LossWords, OfAReason) {
  EXPECT_EQ(LossWords::of(LostReason::camera), LossDetail::one_camera);
  EXPECT_EQ(LossWords::of(LostReason::few_features), LossDetail::covered);
  EXPECT_EQ(LossWords::of(LostReason::high_residual), LossDetail::doubtful);
}

TEST(ImagePyramid, APlaceLiesAtHalfOfItAtEachLevel) {
  cv::Mat image(160, 200, CV_8U, cv::Scalar(0));
  cv::circle(image, {96, 64}, 14, cv::Scalar(255), -1, cv::LINE_AA);
  const ImagePyramid pyramid(image);
  for (int l = 0; l < kLevels; ++l) {
    const cv::Moments m = cv::moments(greyOf(pyramid.level[std::size_t(l)]));
    EXPECT_NEAR(m.m10 / m.m00, 96.0 / (1 << l), 0.05) << l;
    EXPECT_NEAR(m.m01 / m.m00, 64.0 / (1 << l), 0.05) << l;
  }
}

TEST(ImagePyramid, KeepsGreyLevels) {
  const cv::Mat image(96, 128, CV_8U, cv::Scalar(173));
  const ImagePyramid pyramid(image);
  for (const auto& level : pyramid.level) {
    const cv::Mat1f grey = greyOf(level);
    ASSERT_FALSE(grey.empty());
    EXPECT_EQ(cv::norm(grey, cv::Mat1f(grey.size(), 173.f), cv::NORM_INF), 0);
  }
}

}  // namespace
}  // namespace facenav::head_tracking
