// Treatment at home: the presenter's steps and refusals, and the window at three sizes.
// FACENAV_GUI_PICTURES=DIR keeps images.

#include <gtest/gtest.h>

#include <QPushButton>
#include <QtTest/QTest>
#include <atomic>
#include <cstdlib>

#include "facenav/casefile/kept_session.h"
#include "facenav/casefile/sign_off.h"
#include "facenav/core/zip_file.h"
#include "facenav/plan/expert_pose.h"
#include "facenav/scene/display.h"
#include "home/fitted_words.h"
#include "home/home_window.h"
#include "home/sign_view.h"
#include "home_fixtures.h"
#include "shell/appearance.h"
#include "support/made_session.h"

namespace facenav::ui {
namespace {

using namespace home_fixtures;
using Stage = HomePresenter::Stage;

class HomePresenterTest : public ::testing::Test {
 protected:
  void open(HomePresenter& home) {
    home.open(QString::fromStdString(case_.string()));
    settle();
    home.play(QString::fromStdString(recording_.string()));
  }
  void settle() {
    fixtures::waitFor([&] { return !tasks_.isRunning(); });
  }
  bool guides(HomePresenter& home) {
    home.act();
    return fixtures::waitFor([&] { return home.stage() == Stage::guiding; });
  }
  testing::TemporaryFolder folder_;
  fs::path case_ = writeHomeCase(folder_.path()), recording_ = writeCapturedRecording(folder_.path());
  std::shared_ptr<Seen> seen_ = std::make_shared<Seen>();
  TaskRunner tasks_;
};

TEST_F(HomePresenterTest, GoesThroughThreeStepsAndEndsWithOneFile) {
  const Services services = homeServices(seen_);
  HomePresenter home(services, tasks_);
  open(home);
  ASSERT_EQ(home.stage(), Stage::sit);
  EXPECT_EQ(home.actionWords(), "START");
  seen_->head = false;
  seen_->coil = false;
  ASSERT_TRUE(guides(home));
  const auto step = [&](steps::HomeStep wanted) {
    return fixtures::waitFor([&] { return home.advice().step == wanted; });
  };
  EXPECT_TRUE(step(steps::HomeStep::sit));
  seen_->head = true;
  EXPECT_TRUE(step(steps::HomeStep::hold));
  seen_->coil = true;
  EXPECT_TRUE(step(steps::HomeStep::follow));
  EXPECT_TRUE(fixtures::waitFor([&] { return home.advice().sign == steps::HomeSign::hold; }));
  home.countPulse();
  EXPECT_TRUE(fixtures::waitFor([&] { return home.pulseCounts().on_target == 1; }));
  EXPECT_EQ(home.plannedPulses(), 200);
  home.act();
  EXPECT_EQ(home.stage(), Stage::guiding) << "it is asked once";
  EXPECT_EQ(home.actionWords(), "YES, FINISH");
  home.goOn();
  EXPECT_EQ(home.actionWords(), "FINISH");
  home.act();
  home.act();
  ASSERT_TRUE(fixtures::waitFor([&] { return home.stage() == Stage::ended; }));
  EXPECT_EQ(home.pulseCounts().on_target, 1) << "still shown at the end";
  const fs::path file = folder_.path() / home.sendBackName().toStdString();
  EXPECT_TRUE(home.save(QString::fromStdString(file.string())));
  EXPECT_EQ(readZip(file).count("pulses.csv"), 1u);
  EXPECT_EQ(home.actionWords(), "CLOSE");
  fs::create_directories(folder_.path() / "desktop");
  const QString desktop = QString::fromStdString((folder_.path() / "desktop").string());
  EXPECT_EQ(home.saveIn({desktop, "/nowhere"}), QStringList{desktop}) << "one place is enough";
  EXPECT_EQ(home.savedAs(), desktop + "/" + home.sendBackName());
}

TEST_F(HomePresenterTest, WithoutAPulseOnTargetNothingIsCalledDone) {
  const Services services = homeServices(seen_);
  HomePresenter home(services, tasks_);
  open(home);
  EXPECT_TRUE(home.stillPicture()) << "a picture while it waits";
  ASSERT_TRUE(guides(home));
  home.act();
  home.act();
  ASSERT_TRUE(fixtures::waitFor([&] { return home.stage() == Stage::ended; }));
  EXPECT_TRUE(home.words().contains("without a pulse on target")) << home.words().toStdString();
}

TEST_F(HomePresenterTest, AnotherPersonAndMovedCamerasDoNotStart) {
  for (const auto& [error, words] :
       {std::pair("not aligned: the face does not fit this MRI", "not the stored one"),
        {"not aligned: the cameras moved", "cameras were moved"}}) {
    const Services services = homeServices(seen_, Eigen::Vector3d::Zero(), error);
    HomePresenter home(services, tasks_);
    open(home);
    home.act();
    ASSERT_TRUE(fixtures::waitFor([&] { return !home.refusal().isEmpty(); }));
    EXPECT_EQ(home.stage(), Stage::sit);
    EXPECT_TRUE(home.words().contains(words)) << home.words().toStdString();
    EXPECT_EQ(home.actionWords(), "TRY AGAIN");
    EXPECT_TRUE(casefile::sessionFolders(case_).empty()) << "no session of what was refused";
  }
}

TEST_F(HomePresenterTest, ACaseThatLacksAPartIsNotUsed) {
  fs::remove(case_ / "coil.json");
  const Services services = homeServices(seen_);
  HomePresenter home(services, tasks_);
  open(home);
  EXPECT_EQ(home.stage(), Stage::unusable);
  EXPECT_TRUE(home.words().contains("names no coil")) << home.words().toStdString();
  EXPECT_TRUE(home.actionWords().isEmpty());
  home.act();
  EXPECT_FALSE(tasks_.isRunning());
}

TEST_F(HomePresenterTest, ALostFaceTakesTheArrowAway) {
  const Services services = homeServices(seen_, {9, 0, 0});
  HomePresenter home(services, tasks_);
  open(home);
  ASSERT_TRUE(guides(home));
  ASSERT_TRUE(fixtures::waitFor([&] { return home.advice().sign == steps::HomeSign::arrow; }));
  seen_->head = false;
  EXPECT_TRUE(fixtures::waitFor([&] { return home.advice().sign == steps::HomeSign::none; }));
  EXPECT_EQ(home.advice().step, steps::HomeStep::sit);
}

TEST_F(HomePresenterTest, TheWindowWorksByKeyboardAndFitsEverySize) {
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  const auto take = [](QWidget& window, const QString& name) {
    QTest::qWait(70);  // longer than the window's refresh
    if (const char* pictures = std::getenv("FACENAV_GUI_PICTURES"))
      window.grab().save(QString("%1/home_%2.png").arg(pictures, name));
  };
  for (const auto& [size, scale, name] : {std::tuple(QSize(1366, 768), 1.0, "1366"),
                                          {QSize(1920, 1080), 1.0, "1920"},
                                          {QSize(1366, 768), 2.0, "1366_double"}}) {
    applyAppearance(*qApp, scale);
    HomeWindow window(homeServices(seen_, {9, -4, 0}));
    auto& home = window.presenter();
    window.resize(size);
    window.show();
    home.open(QString::fromStdString(case_.string()));
    ASSERT_TRUE(fixtures::waitFor([&] { return home.stage() == Stage::sit; }));
    home.play(QString::fromStdString(recording_.string()));
    take(window, QString("sit_") + name);
    QApplication::setActiveWindow(&window);
    seen_->coil = false;
    QTest::keyClick(&window, Qt::Key_Return);
    ASSERT_TRUE(fixtures::waitFor([&] { return home.stage() == Stage::guiding; }));
    ASSERT_TRUE(fixtures::waitFor([&] { return home.advice().step == steps::HomeStep::hold; }));
    take(window, QString("hold_") + name);
    seen_->coil = true;
    auto* sign = window.findChild<SignView*>();
    ASSERT_TRUE(fixtures::waitFor([&] { return sign->sign() == steps::HomeSign::arrow; }));
    QTest::keyClick(&window, Qt::Key_P);
    ASSERT_TRUE(fixtures::waitFor([&] { return home.pulseCounts().outside == 1; }));
    take(window, QString("follow_") + name);
    EXPECT_EQ(window.size(), size) << "no words widen the window";
    for (int i = 0; i < 2; ++i) QTest::keyClick(&window, Qt::Key_Return);
    ASSERT_TRUE(fixtures::waitFor([&] { return home.stage() == Stage::ended; }));
    for (auto* step : window.findChildren<FittedWords*>())
      EXPECT_FALSE(step->words().contains(QChar(0x2713))) << "no pulse was on target";
    home.save(QString::fromStdString((folder_.path() / (std::string(name) + ".zip")).string()));
    take(window, QString("ended_") + name);
  }
  applyAppearance(*qApp, 1.0);
  HomeWindow refused(
      homeServices(seen_, Eigen::Vector3d::Zero(), "not aligned: the face does not fit this MRI"));
  refused.resize(1366, 768);
  refused.show();
  refused.presenter().open(QString::fromStdString(case_.string()));
  ASSERT_TRUE(fixtures::waitFor([&] { return refused.presenter().stage() == Stage::sit; }));
  refused.presenter().play(QString::fromStdString(recording_.string()));
  refused.presenter().act();
  ASSERT_TRUE(fixtures::waitFor([&] { return refused.findChild<SignView*>()->isRefused(); }));
  take(refused, "refused_1366");
}

}  // namespace
}  // namespace facenav::ui
