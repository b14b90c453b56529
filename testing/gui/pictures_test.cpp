// Pictures of every page with a real case, to be looked at: FACENAV_GUI_CASES=DIR (a folder of cases, which
// is written to: give a copy) FACENAV_GUI_PICTURES=DIR. Skipped without them.

#include <gtest/gtest.h>

#include <QListWidget>
#include <cstdlib>

#include "facenav/atlas/brain_template.h"
#include "facenav/core/error.h"
#include "facenav/scene/display.h"
#include "gui_fixtures.h"
#include "main_window.h"
#include "workspaces/prepare/prepare_workspace.h"

namespace facenav::ui {
namespace {

class Pictures {
 public:
  Pictures(MainWindow& window, QString folder) : window_(window), folder_(std::move(folder)) {}
  void take(const QString& name) {
    fixtures::waitFor([this] { return !window_.tasks().isRunning(); }, 60000);
    fixtures::waitFor([] { return false; }, 700);  // drawn, settled
    EXPECT_TRUE(window_.grab().save(folder_ + "/" + name + ".png"));
  }

 private:
  MainWindow& window_;
  QString folder_;
};

/// One job that stands still half-way, one that fails.
Services exampleServices() {
  Services services;
  services.listSeries = [](const std::filesystem::path& folder, TaskMonitor&) {
    if (folder.filename() == "broken") throw Error("no DICOM image in the folder", {}, "choose another");
    dicom::SeriesInfo t1, survey;
    t1.description = "T1 MPRAGE sag", t1.modality = survey.modality = "MR", t1.plane = "sagittal";
    t1.date = survey.date = "2026-11-20", t1.rows = t1.columns = 256, t1.slices = 176;
    t1.spacing_mm = {1, 1, 1}, t1.id = t1.series_uid = "1.2.3", t1.is_loadable = true;
    t1.is_recommended = t1.is_fit_for_navigation = true, t1.fitness = "fit for navigation";
    survey.description = "survey", survey.problem = "three planes of 3 slices each";
    return std::vector<dicom::SeriesInfo>{t1, survey};
  };
  services.prepareCase = [](const PrepareOrder&, TaskMonitor& monitor) {
    for (;;) {
      monitor.report("finding the brain", 0.6);
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  };
  services.readTemplate = [] { return atlas::readColin27(); };
  return services;
}

TEST(Pictures, OfEveryPage) {
  const char *cases = std::getenv("FACENAV_GUI_CASES"), *pictures = std::getenv("FACENAV_GUI_PICTURES");
  if (!cases || !pictures) GTEST_SKIP() << "FACENAV_GUI_CASES and FACENAV_GUI_PICTURES are not set";
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  const testing::TemporaryFolder folder;
  MainWindow window(exampleServices());
  window.resize(1480, 920);
  window.show();
  window.setCasesFolder(cases);
  const auto entries = casefile::listCases(cases);
  ASSERT_FALSE(entries.empty());
  Pictures shots(window, pictures);
  for (const char* name : {"broken", "head_1", "head_2"}) {
    std::filesystem::create_directories(folder.path() / name);
    window.queue().add(QString::fromStdString((folder.path() / name).string()));
  }
  shots.take("1_worklist");
  window.openCase(QString::fromStdString(entries.front().folder.string()));
  shots.take("3_check");
  window.setPrepareStep(PrepareStep::sign_off);
  shots.take("4_sign_off");
  window.setWorkspace(Workspace::treat);
  shots.take("6_treat_not_signed_off");
  for (const auto& entry : entries)
    casefile::signOff(casefile::CaseStore::open(entry.folder), {"XY", "", true});
  window.openCase(QString::fromStdString(entries.front().folder.string()));
  window.setWorkspace(Workspace::plan);
  shots.take("5_plan");
  window.setPrepareStep(PrepareStep::sign_off);
  shots.take("4_signed_off");
  window.setPrepareStep(PrepareStep::worklist);
  shots.take("1_worklist_checked");
}

}  // namespace
}  // namespace facenav::ui
