#include "support/kept_pictures.h"

#include <gtest/gtest.h>

#include <QLabel>

#include "support/test_data.h"

namespace facenav::testing {
namespace {

using Use = KeptPictures::Use;

QImage grey(int level) {
  QImage picture(342, 192, QImage::Format_Grayscale8);
  picture.fill(qRgb(level, level, level));
  return picture;
}

/// The picture with one block, 8 x 8 pixels, brighter.
QImage withBlock(int level, int brighter) {
  QImage picture = grey(level);
  for (int y = 80; y < 88; ++y)
    for (int x = 160; x < 168; ++x) picture.scanLine(y)[x] = uchar(level + brighter);
  return picture;
}

TEST(KeptPictures, TheDifferenceIsThatOfTheBlockThatDiffersMost) {
  EXPECT_EQ(difference(grey(100), grey(100)), 0);
  EXPECT_EQ(difference(grey(100), withBlock(100, 40)), 40);
  EXPECT_EQ(difference(grey(100), QImage(10, 10, QImage::Format_Grayscale8)), 255);
}

TEST(KeptPictures, AnotherColourOfTheSameBrightnessDiffers) {
  QImage blue(228, 128, QImage::Format_RGB888), orange = blue;
  blue.fill(QColor(84, 178, 255));
  orange.fill(QColor(255, 160, 51));
  EXPECT_EQ(difference(blue, blue), 0);
  EXPECT_EQ(difference(blue, orange), 204) << "blue differs most";
}

TEST(KeptPictures, TheToleranceIsSixTimesTheNoiseBetweenTwoRuns) {
  const TemporaryFolder folder;
  const KeptPictures renew(folder.path(), Use::renew), noise(folder.path(), Use::measure_noise),
      compare(folder.path(), Use::compare);
  EXPECT_EQ(compare.show("page", grey(100)), "there is no kept picture of page");
  EXPECT_EQ(renew.show("page", grey(100)), "");
  EXPECT_EQ(compare.tolerance("page"), 15) << "six times the least noise";
  EXPECT_EQ(noise.show("page", withBlock(100, 3)), "");
  EXPECT_EQ(compare.tolerance("page"), 18);
  EXPECT_EQ(compare.show("page", withBlock(100, 18)), "");
  EXPECT_EQ(compare.show("page", withBlock(100, 19)),
            "page differs from the kept picture by 19.0 grey levels; 18.0 are allowed");
}

TEST(KeptPictures, ASmallPictureHidesThePartsThatChange) {
  QWidget window;
  window.resize(1366, 768);
  auto* clock = new QLabel("09:41", &window);
  clock->setObjectName("clock");
  clock->setGeometry(100, 100, 400, 200);
  window.show();
  const QImage first = smallPicture(window, {"clock"});
  EXPECT_EQ(first.size(), QSize(342, 192));
  clock->setStyleSheet("background: white");
  EXPECT_EQ(difference(first, smallPicture(window, {"clock"})), 0);
  EXPECT_GT(difference(first, smallPicture(window, {})), 50);
}

}  // namespace
}  // namespace facenav::testing
