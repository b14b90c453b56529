#include "treat/camera_row.h"

#include <gtest/gtest.h>

#include <QTest>

#include "facenav/session/session.h"
#include "shell/image_view.h"

namespace facenav::ui {
namespace {

session::NavigationState stateAt(double arrived_s, bool has_coil) {
  session::NavigationState state;
  state.arrived = {arrived_s};
  state.head = {head_tracking::HeadPose{}, 0.9};
  state.camera_T_mri = {RigidTransform<Camera, Mri>(), 0.9};
  if (!has_coil) return state;
  state.coil = {coil_tracking::CoilPose{}, 0.9};
  state.camera_T_coil = {RigidTransform<Camera, Coil>(), 0.9};
  return state;
}

std::shared_ptr<const session::NavigationState> shared(const session::NavigationState& state) {
  return std::make_shared<session::NavigationState>(state);
}

std::shared_ptr<const pictures::DrawnOverlay> redPictureOf(const session::NavigationState& state) {
  auto drawn = std::make_shared<pictures::DrawnOverlay>();
  for (RgbImage* image : {&drawn->overlay.left, &drawn->overlay.right}) {
    *image = RgbImage(40, 30);
    for (int v = 0; v < 30; ++v)
      for (int u = 0; u < 40; ++u) image->pixel(u, v)[0] = 250;
  }
  drawn->state = shared(state);
  return drawn;
}

/// Returns true if the middle of both views is red.
bool isRed(CameraRow& row) {
  const QImage image = row.grab().toImage();
  const int middle = image.height() / 2;
  return image.pixelColor(image.width() / 4, middle).red() > 200 &&
         image.pixelColor(3 * image.width() / 4, middle).red() > 200;
}

class CameraRowTest : public ::testing::Test {
 protected:
  CameraRowTest() { row_.resize(600, 240); }
  CameraRow row_;
};

TEST_F(CameraRowTest, AClickNamesThePictureItsPixelAndItsState) {
  const auto tracked = stateAt(10.0, true);
  row_.follow(shared(tracked));
  const auto drawn = redPictureOf(tracked);
  std::vector<std::pair<stereo::PictureSide, QPointF>> clicks;
  std::shared_ptr<const session::NavigationState> of;
  QObject::connect(&row_, &CameraRow::picked, [&](auto side, const QPointF& px, auto state) {
    clicks.emplace_back(side, px);
    of = state;
  });
  const auto views = row_.findChildren<ImageView*>();
  ASSERT_EQ(views.size(), 2);
  row_.show();
  QTest::mouseClick(views[0], Qt::LeftButton, {}, views[0]->rect().center());
  EXPECT_TRUE(clicks.empty()) << "no picture is shown yet";
  row_.showDrawn(drawn);
  for (auto* view : views) QTest::mouseClick(view, Qt::LeftButton, {}, view->rect().center());
  QTest::mouseClick(views[0], Qt::LeftButton, {}, {1, 1});  // beside the picture, or its corner
  ASSERT_GE(clicks.size(), 2u);
  EXPECT_EQ(clicks[0].first, stereo::PictureSide::left);
  EXPECT_EQ(clicks[1].first, stereo::PictureSide::right);
  for (int i : {0, 1}) {  // the picture has 40 x 30 px
    EXPECT_NEAR(clicks[std::size_t(i)].second.x(), 19.5, 0.2);
    EXPECT_NEAR(clicks[std::size_t(i)].second.y(), 14.5, 0.2);
  }
  EXPECT_EQ(of, drawn->state);
}

TEST_F(CameraRowTest, ShowsAPictureOfTheNewestStateUntilItIsLost) {
  const auto tracked = stateAt(10.0, true);
  row_.follow(shared(tracked));
  row_.showDrawn(redPictureOf(tracked));
  EXPECT_TRUE(isRed(row_));
  row_.follow(shared(stateAt(10.03, true)));  // its own image is still being drawn
  EXPECT_TRUE(isRed(row_));
  row_.follow(shared(stateAt(10.06, false)));
  EXPECT_FALSE(isRed(row_)) << "the coil is lost, the picture shows it";
  EXPECT_EQ(row_.shown(), nullptr);
}

TEST_F(CameraRowTest, APictureThatComesTooLateIsNotShown) {
  row_.follow(shared(stateAt(10.06, false)));
  row_.showDrawn(redPictureOf(stateAt(10.0, true)));  // from before the coil was lost
  EXPECT_FALSE(isRed(row_));
  row_.follow(shared(stateAt(12.0, true)));
  row_.showDrawn(redPictureOf(stateAt(11.5, true)));  // half a second old
  EXPECT_FALSE(isRed(row_));
  row_.showDrawn(redPictureOf(stateAt(12.1, true)));  // from another run
  EXPECT_FALSE(isRed(row_));
  EXPECT_EQ(row_.shown(), nullptr);
}

TEST_F(CameraRowTest, SaysThatPicturesComeTooLateUntilOneComesInTime) {
  const auto words = [&] { return row_.findChild<ImageView*>()->words(); };
  const auto tracked = stateAt(12.0, true);
  row_.follow(shared(tracked));
  EXPECT_EQ(words(), "left camera");
  row_.showDrawn(redPictureOf(stateAt(11.5, true)));
  EXPECT_TRUE(words().contains("too late")) << words().toStdString();
  row_.follow(shared(tracked));
  EXPECT_TRUE(words().contains("too late")) << "nothing came since";
  row_.showDrawn(redPictureOf(tracked));
  EXPECT_TRUE(isRed(row_));
  row_.follow(shared(stateAt(12.5, true)));
  EXPECT_TRUE(words().contains("too late")) << "the picture that was shown is half a second old";
  row_.showDrawn(redPictureOf(stateAt(12.5, true)));
  row_.follow(shared(stateAt(12.5, false)));
  EXPECT_EQ(words(), "left camera") << "the coil is lost; the picture was in time";
}

TEST_F(CameraRowTest, NoPictureOfASessionComesBackIntoThePreview) {
  const auto tracked = stateAt(10.0, true);
  row_.follow(shared(tracked));
  cameras::StereoFrame frame;
  frame.left = frame.right = cv::Mat(30, 40, CV_8UC1, cv::Scalar(90));
  row_.showPlain(frame);
  row_.showDrawn(redPictureOf(tracked));
  EXPECT_FALSE(isRed(row_));
  row_.follow(shared(tracked));  // no preview remains after a session
  EXPECT_NE(row_.grab().toImage().pixelColor(150, 120).red(), 90);
}

TEST_F(CameraRowTest, SaysWhyNothingCouldBeDrawn) {
  const auto tracked = stateAt(10.0, true);
  pictures::DrawnOverlay failed{{}, shared(tracked), {}, "no memory"};
  row_.follow(shared(tracked));
  const QImage before = row_.grab().toImage();
  row_.showDrawn(std::make_shared<pictures::DrawnOverlay>(failed));
  EXPECT_NE(row_.grab().toImage(), before);
}

}  // namespace
}  // namespace facenav::ui
