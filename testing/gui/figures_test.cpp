// Figures in the window: their words are in its language and its own font paints them, and a scene's colours
// are seen on the background of each theme.

#include <gtest/gtest.h>

#include <QApplication>
#include <QRegularExpression>
#include <mutex>
#include <set>

#include "facenav/pictures/camera_overlay.h"
#include "facenav/pictures/picture_words.h"
#include "facenav/pictures/pose_overlay.h"
#include "facenav/report/review_charts.h"
#include "facenav/scene/palette.h"
#include "shell/language.h"
#include "shell/shown_words.h"
#include "shell/theme.h"
#include "unit/case/casefile/made_pulse.h"
#include "unit/treat/session/session_fakes.h"

namespace facenav::ui {
namespace {

namespace fakes = session::fakes;

constexpr LostReason kReasons[] = {LostReason::no_face,       LostReason::few_features, LostReason::no_marker,
                                   LostReason::high_residual, LostReason::camera,       LostReason::stale};

/// English words that a text shows in Japanese too: those not of units and established abbreviations.
QStringList englishIn(const QString& shown) {
  static const QRegularExpression kWord("[A-Za-z]{3,}");
  QStringList found;
  for (auto it = kWord.globalMatch(shown); it.hasNext();)
    if (const QString word = it.next().captured(); word != "deg" && word != "MEP") found << word;
  return found;
}

class FigureWords : public ::testing::Test {
 protected:
  void SetUp() override {
    applyLanguage(*qApp, "ja");
    pictures::setWordsPainter([this](const auto&, const pictures::PictureWords& words) {
      const std::lock_guard lock(mutex_);
      handed_.insert(words.text);
    });
  }
  void TearDown() override { applyLanguage(*qApp, "en"); }
  std::set<std::string> handed() {
    const std::lock_guard lock(mutex_);
    return handed_;
  }
  void expectJapanese(const std::string& words) {
    EXPECT_TRUE(englishIn(shownWords(words)).isEmpty()) << words << " -> " << shownWords(words).toStdString();
  }

 private:
  std::mutex mutex_;
  std::set<std::string> handed_;
};

session::NavigationState aState() {
  auto navigator = session::Navigator(
      fakes::setup(), std::make_unique<fakes::Head>([](auto) { return RigidTransform<Camera, Head>(); }),
      std::make_unique<fakes::Coil>(std::nullopt));
  return navigator.process(fakes::frame(0, 0));
}

TEST_F(FigureWords, CaptionsOfTheLivePicturesAreInTheWindowsLanguage) {
  const auto state = aState();
  pictures::drawOverlay(fakes::rig(), state);
  for (const LostReason reason : kReasons)
    pictures::drawOverlay(fakes::rig(), session::blanked(state, reason));
  EXPECT_GE(handed().size(), 8u) << "both cameras, with several titles";
  for (const auto& words : handed()) expectJapanese(words);
}

TEST_F(FigureWords, CaptionsOfStoredPicturesAreInTheWindowsLanguage) {
  const auto frame = fakes::frame(0, 0);
  for (const LostReason reason : kReasons) {
    const auto state = session::blanked(aState(), reason);
    for (const auto& title : session::lossTitles(state)) {
      std::string loss = title;  // as pulses and poses keep it
      for (char& c : loss) c = char(std::tolower(static_cast<unsigned char>(c)));
      pictures::StoredPoses poses;
      poses.loss = loss;
      pictures::drawPoses(fakes::rig(), *frame, poses, {}, {});
    }
  }
  EXPECT_GE(handed().size(), 4u);
  for (const auto& words : handed()) expectJapanese(words);
}

TEST_F(FigureWords, PlacesOnTheAlignedSkinAreInTheWindowsLanguage) {
  for (const char* place : {"nose tip", "nasion", "left tragus", "right tragus"}) expectJapanese(place);
}

TEST_F(FigureWords, ChartsOfASessionAreInTheWindowsLanguage) {
  int texts = 0;
  const auto expectTranslated = [&](const report::Chart& chart) {
    for (const auto& shape : chart.shapes)
      if (!shape.text.empty()) expectJapanese(shape.text), ++texts;
  };
  std::vector<casefile::ReviewedPulse> pulses;
  for (int i = 1; i <= 3; ++i) pulses.push_back({casefile::madePulse(i, 50.0 * i), false, ""});
  for (const auto& column : report::pulseColumns())
    for (const auto& given : {std::vector<casefile::ReviewedPulse>(), pulses}) {
      expectTranslated(report::histogramOf(given, column.column));
      expectTranslated(report::driftChart(given, column.column));
    }
  EXPECT_GE(texts, 8 * int(report::pulseColumns().size())) << "each chart has a title and a line below";
}

TEST(FigurePainter, WordsAreSmallerWhereTheyWouldLeaveThePicture) {
  const auto painted = [](const char* language, int width_px) {
    applyLanguage(*qApp, language);
    cameras::StereoRig rig = fakes::rig();
    auto frame = *fakes::frame(0, 0);
    frame.left = frame.right = cv::Mat(480, width_px, CV_8UC1, cv::Scalar(100));
    pictures::StoredPoses poses;
    poses.loss = "face hidden";
    return pictures::drawPoses(rig, frame, poses, {}, {}).left;
  };
  const auto inkIn = [](const RgbImage& image, int from) {
    int ink = 0;
    for (int v = 0; v < 40; ++v)
      for (int u = from; u < image.width_px; ++u) ink += image.pixel(u, v)[0] > 150;
    return ink;
  };
  const auto english = painted("en", 640), japanese = painted("ja", 640), narrow = painted("ja", 160);
  applyLanguage(*qApp, "en");
  EXPECT_NE(english.rgb, japanese.rgb);
  EXPECT_GT(inkIn(japanese, 0), 300);
  EXPECT_GT(inkIn(narrow, 0), 100);
  EXPECT_EQ(inkIn(narrow, 158), 0) << "the last letter is cut";
}

TEST(FigureColours, AreSeenOnTheScenesBackgroundOfEachTheme) {
  namespace palette = scene::palette;
  const auto qcolor = [](const palette::Rgb& c) { return QColor::fromRgbF(c[0], c[1], c[2]); };
  for (const Theme theme : {Theme::dark, Theme::light})
    for (const Colour back : {Colour::scene_low, Colour::scene_high}) {
      const QColor ground = themeColour(back, theme);
      EXPECT_GE(contrast(qcolor(palette::kText), ground), 4.5) << "words";
      for (const auto& shape : {palette::kBlue, palette::kOrange, palette::kLost, palette::kMuted,
                                palette::kSkin, palette::kCoil})
        EXPECT_GE(contrast(qcolor(shape), ground), 3.0) << qcolor(shape).name().toStdString();
    }
}

}  // namespace
}  // namespace facenav::ui
