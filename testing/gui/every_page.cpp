#include "every_page.h"

#include <QAbstractButton>

#include "gui_fixtures.h"
#include "plan/brain_look_panel.h"
#include "prepare/prepare_workspace.h"
#include "review/review_workspace.h"
#include "shell/main_window.h"
#include "support/made_session.h"
#include "treat/treat_workspace.h"

namespace facenav::ui::fixtures {
namespace {

constexpr int kSettle_ms = 30;

}  // namespace

QAbstractButton* buttonWith(QWidget& in, const QString& words) {
  for (auto* button : in.findChildren<QAbstractButton*>())
    if (button->isVisible() && button->text().contains(words)) return button;
  return nullptr;
}

QAbstractButton* camerasButton(QWidget& in) {
  return buttonWith(in, TreatWorkspace::tr("1 Cameras %1").remove("%1").trimmed());
}

std::vector<Page> everyPage() {
  const auto step = [](PrepareStep which) { return [which](MainWindow& w) { w.setPrepareStep(which); }; };
  const auto treat = [](bool has_figures) {
    return [has_figures](MainWindow& window) {
      window.setWorkspace(Workspace::treat);
      auto* cameras = camerasButton(window);
      if (cameras->isChecked() == has_figures) cameras->click();
    };
  };
  const auto review = [](ReviewPage page) {
    return [page](MainWindow& window) {
      window.setWorkspace(Workspace::review);
      window.findChild<ReviewWorkspace*>()->setPage(page);
      waitFor([&] { return window.review().session() && !window.review().isReading(); }, 5000);
      if (page == ReviewPage::replay) waitFor([&] { return window.replay().isOpen(); }, 5000);
    };
  };
  return {{"1_worklist", step(PrepareStep::worklist)},
          {"2_series", step(PrepareStep::series)},
          {"2_archive", step(PrepareStep::archive)},
          {"3_check", step(PrepareStep::check)},
          {"4_sign_off", step(PrepareStep::sign_off)},
          {"5_plan", [](MainWindow& w) { w.setWorkspace(Workspace::plan); }},
          {"5_plan_side_by_side",
           [](MainWindow& w) {
             w.setWorkspace(Workspace::plan);
             if (auto* button = buttonWith(w, BrainLookPanel::tr("Side by side"))) button->click();
             waitFor([&] { return !w.cortex().isMaking() && w.cortex().cortex(); }, 30000);
           }},
          {"6_treat_cameras", treat(false)},
          {"6_treat_figures", treat(true)},
          {"8_review_pulses", review(ReviewPage::pulses)},
          {"8_review_replay", review(ReviewPage::replay)},
          {"8_review_compare", review(ReviewPage::compare)},
          {"8_review_report", review(ReviewPage::report)}};
}

std::vector<Page> pagesAndTools() {
  auto pages = everyPage();
  const std::pair<const char*, TreatSide::Tool> tools[] = {{"6_treat_motor", TreatSide::Tool::motor},
                                                           {"6_treat_session", TreatSide::Tool::session},
                                                           {"6_treat_check", TreatSide::Tool::check},
                                                           {"6_treat_aim", TreatSide::Tool::aim}};
  for (const auto& [name, tool] : tools)
    pages.push_back({name, [tool = tool](MainWindow& window) {
                       window.setWorkspace(Workspace::treat);
                       auto* cameras = camerasButton(window);
                       if (cameras->isChecked()) cameras->click();
                       window.findChild<TreatWorkspace*>()->showTool(tool);
                     }});
  return pages;
}

void settle() {
  for (int i = 0; i < 3; ++i) {
    QApplication::sendPostedEvents();
    QApplication::processEvents();
  }
  waitFor([] { return false; }, kSettle_ms);
}

std::filesystem::path writeFullCase(const std::filesystem::path& folder) {
  auto prepared = ballWithBrain();
  prepared.findings = {
      "the brain measures 268 ml, adults have 1100 to 1700 ml: check its outline",
      "the slices are thicker than 3 mm: the brain's surface is coarse",
      "look at the left temporal pole: the mask's edge is uncertain by 3 mm there (confidence 0.40)"};
  prepared.label = "A name that is rather long, Family, Given, born 1970-01-31";
  const auto store = casefile::CaseStore::create(folder / "case", prepared, {}, false);
  guidance::TreatmentPlan plan;
  for (const char* name : {"M1 hand L", "M1 hand R", "DLPFC left, by Beam F3, second try"})
    plan.targets.push_back(guidance::planTarget(name, prepared.scalp, Point<Mri>(-30, 5, 30), 0.8, 4.0));
  store.setTargets(plan);
  testing::MadeSession made;
  made.has_meps = true;
  for (int i = 0; i < 2; ++i) testing::writeMadeSession(store.folder(), plan.targets[0], made);
  return store.folder();
}

}  // namespace facenav::ui::fixtures
