// A session as it is treated (real trackers, a recording played as if live, pulses by the button), then
// images of every page of Review, for people to look at. FACENAV_GUI_CASES=DIR is a folder whose first case
// is treated (use a copy), FACENAV_GUI_RECORDING=DIR its recording, FACENAV_GUI_PICTURES=DIR the output.
// Skipped without them.

#include <gtest/gtest.h>

#include <QElapsedTimer>
#include <QPushButton>
#include <cmath>
#include <cstdlib>
#include <fstream>

#include "facenav/casefile/kept_session.h"
#include "facenav/scene/display.h"
#include "gui_fixtures.h"
#include "registrations.h"
#include "review/review_workspace.h"
#include "shell/appearance.h"
#include "shell/main_window.h"

namespace facenav::ui {
namespace {

namespace fs = std::filesystem;

constexpr int kPulses = 220;

const char* environment(const char* name) { return std::getenv(name); }

void giveTrains(MainWindow& window) {
  QPushButton* pulse = nullptr;
  for (auto* button : window.findChildren<QPushButton*>())
    if (button->text().contains("Pulse given")) pulse = button;
  ASSERT_TRUE(pulse);
  QElapsedTimer clock;
  clock.start();
  // Pulses at 10 Hz, from a second after the start on.
  for (int i = 0; i < kPulses && window.treat().isRunning(); ++i) {
    fixtures::waitFor([&] { return clock.elapsed() >= 1000 + 100 * i; }, 60000);
    emit pulse->pressed();
  }
}

/// Writes MEPs for the single pulses of a hunt: larger, the nearer the coil is to the target; on a clock 12.5
/// s behind.
void writeMeps(const fs::path& session, const fs::path& csv) {
  std::ofstream file(csv);
  file << "t_s,mep_uv,latency_ms\n";
  int n = 0;
  for (const auto& reviewed : casefile::readSessionPulses(session).pulses)
    if (const auto& pulse = reviewed.pulse; pulse.offset && ++n % 7 == 0)
      file << *pulse.t_s - 12.5 << ","
           << std::round(600.0 * std::exp(-0.02 * std::pow(pulse.offset->distance_mm, 2))) << ",22.1\n";
}

/// Takes the coil's slices in the 3-D scene, with a live coil.
void takeLive(MainWindow& window) {
  for (auto* button : window.findChildren<QPushButton*>())
    if (button->text() == "in 3-D" && !button->isChecked()) button->click();
  fixtures::waitFor([&] { return bool(window.treat().state()->camera_T_coil); }, 20000);
  fixtures::waitFor([] { return false; }, 300);
  window.grab().save(QString(environment("FACENAV_GUI_PICTURES")) + "/treat_live_slices.png");
}

void treatOnce(const fs::path& case_folder, const char* recording) {
  casefile::signOff(casefile::CaseStore::open(case_folder), {"XY", "", true});
  MainWindow window(servicesWith(app::makeRegistrations));
  window.show();
  window.openCase(QString::fromStdString(case_folder.string()));
  ASSERT_TRUE(fixtures::waitFor([&] { return !window.tasks().isRunning(); }, 60000));
  window.setWorkspace(Workspace::treat);
  window.play(recording, true);
  ASSERT_TRUE(fixtures::waitFor([&] { return window.treat().isRunning(); }, 120000));
  takeLive(window);
  giveTrains(window);
  fixtures::waitFor([&] { return window.treat().pulses() >= kPulses - 5; }, 5000);
  EXPECT_GE(window.treat().pulses(), 200);
}

void takePages(const fs::path& case_folder, const char* recording, const QString& pictures,
               const QString& prefix, const QSize& size) {
  MainWindow window{Services{}};
  window.resize(size);
  window.show();
  window.openCase(QString::fromStdString(case_folder.string()));
  ASSERT_TRUE(fixtures::waitFor([&] { return !window.tasks().isRunning(); }, 60000));
  window.setWorkspace(Workspace::review);
  auto& review = window.review();
  ASSERT_TRUE(fixtures::waitFor([&] { return review.session() && !review.isReading(); }, 60000));
  auto* page = window.findChild<ReviewWorkspace*>();
  const auto take = [&](const char* name) {
    fixtures::waitFor([] { return false; }, 1200);  // time to draw
    EXPECT_TRUE(window.grab().save(pictures + "/" + prefix + name + ".png"));
  };
  take("8_review_error");
  review.setColumn(report::PulseColumn::tilt);
  review.mark(60);
  take("8_review_tilt");
  review.setColumn(report::PulseColumn::mep);
  for (auto* box : page->findChildren<QAbstractButton*>())
    if (box->text() == "MEP map" && !box->isChecked()) box->click();
  take("8_review_mep_map");
  page->setPage(ReviewPage::replay);
  ASSERT_TRUE(fixtures::waitFor([&] { return window.replay().isOpen(); }, 60000));
  window.replay().choosePictures(recording);
  fixtures::waitFor([&] { return window.replay().picture() != nullptr; }, 20000);
  const auto& pulses = window.replay().pulses();
  window.replay().goTo(pulses.empty() ? 500 : pulses[pulses.size() / 2].index);
  take("8_review_replay");
  const auto& moments = window.replay().track().moments;
  for (int i = 0; i < int(moments.size()); ++i)
    if (!moments[std::size_t(i)].has_coil) {
      window.replay().goTo(i);
      break;
    }
  take("8_review_replay_lost");
  page->setPage(ReviewPage::compare);
  take("8_review_compare");
  review.makeReport(false);
}

TEST(ReviewPictures, OfASessionOfTheVirtualRoom) {
  const char *cases = environment("FACENAV_GUI_CASES"), *recording = environment("FACENAV_GUI_RECORDING"),
             *pictures = environment("FACENAV_GUI_PICTURES");
  if (!cases || !pictures || !recording)
    GTEST_SKIP() << "FACENAV_GUI_CASES, _PICTURES and _RECORDING are not set";
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  const fs::path case_folder = casefile::listCases(cases).front().folder;
  while (casefile::sessionFolders(case_folder).size() < 2) treatOnce(case_folder, recording);
  const auto newest = casefile::sessionFolders(case_folder).back();
  if (casefile::readSessionPulses(newest).edited_meps.empty()) {
    const fs::path csv = fs::path(pictures) / "emg.csv";
    writeMeps(newest, csv);
    CaseModel model;
    TaskMonitor monitor;
    model.open(loadCase(case_folder, monitor));
    ReviewPresenter review(model);
    review.refresh();
    ASSERT_TRUE(fixtures::waitFor([&] { return review.session() && !review.isReading(); }, 60000));
    review.importMeps(QString::fromStdString(csv.string()), 12.5);
    fixtures::waitFor([&] { return !review.isReading(); }, 20000);
  }
  for (const auto& [prefix, size, scale] :
       {std::tuple("1366_", QSize(1366, 768), 1.0), std::tuple("1920_", QSize(1920, 1080), 1.0),
        std::tuple("doubled_", QSize(2560, 1440), 2.0)}) {
    applyAppearance(*qApp, scale);
    takePages(case_folder, recording, pictures, prefix, size);
  }
  applyAppearance(*qApp);
}

}  // namespace
}  // namespace facenav::ui
