// The Help menu of the main window: help for the page in view, all shortcuts, About.

#include <QApplication>
#include <QMenuBar>
#include <QStackedWidget>

#include "prepare/prepare_workspace.h"
#include "review/review_workspace.h"
#include "shell/about_words.h"
#include "shell/help_window.h"
#include "shell/main_window.h"
#include "shell/shortcut_list.h"
#include "treat/treat_side.h"

namespace facenav::ui {

void MainWindow::addHelpMenu() {
  auto* help = menuBar()->addMenu(tr("&Help"));
  help->addAction(tr("&Help for this page"), this, &MainWindow::showHelp, Qt::Key_F1);
  help->addAction(tr("&Manual"), this, [this] { HelpWindow::of(*this).showPage("README.md"); });
  help->addAction(
      tr("&Keyboard shortcuts"), this,
      [this] { HelpWindow::of(*this).showHtml(tr("Keyboard shortcuts"), shortcutsAsHtml(shortcuts())); },
      Qt::CTRL + Qt::Key_F1);
  help->addSeparator();
  help->addAction(tr("&About FaceNav"), this,
                  [this] { HelpWindow::of(*this).showHtml(tr("About FaceNav"), aboutAsHtml()); });
}

namespace {

const QString kInTheWindow = "in-the-window";

struct ManualPlace {
  QString page, heading;
};

ManualPlace manualPlaceOf(PrepareStep step) {
  switch (step) {
    case PrepareStep::worklist:
      break;
    case PrepareStep::series:
      return {"prepare.md", "look-what-a-folder-holds-facenav-series"};
    case PrepareStep::check:
    case PrepareStep::sign_off:
      return {"prepare.md", "check-and-sign-off-facenav-check"};
    case PrepareStep::archive:
      return {"prepare.md", "fetch-a-series-from-the-archive-facenav-pacs"};
  }
  return {"prepare.md", kInTheWindow};
}

ManualPlace manualPlaceOf(ReviewPage page) {
  switch (page) {
    case ReviewPage::pulses:
      return {"review.md", "the-pulses-facenav-pulses"};
    case ReviewPage::report:
      return {"review.md", "for-the-chart-facenav-report"};
    case ReviewPage::replay:
    case ReviewPage::compare:
      break;
  }
  return {"review.md", kInTheWindow};
}

/// Treat's place by what is to be done next, or by the tool that is chosen.
ManualPlace manualPlaceOf(const TreatSide& side, const TreatPresenter& treat) {
  if (side.isShown(TreatSide::Tool::motor)) return {"treat.md", "the-motor-threshold-facenav-threshold"};
  if (side.isShown(TreatSide::Tool::session)) return {"treat.md", "where-pulses-come-from"};
  if (side.isShown(TreatSide::Tool::check)) return {"treat.md", "judge-the-alignment"};
  const auto state = treat.state();
  if (treat.isGuiding() && state && (!state->camera_T_mri || !state->coil))
    return {"messages.md", "on-the-screen-during-a-treatment"};
  if (treat.hasRecording() && !treat.isAligned()) return {"align.md", "how-sure-it-is"};
  return {"treat.md", kInTheWindow};
}

}  // namespace

/// Opens the manual where it describes the part that has the focus, else the page and tool in view.
void MainWindow::showHelp() {
  if (HelpWindow::showPlaceOf(QApplication::focusWidget(), *this)) return;
  ManualPlace place{"plan.md", kInTheWindow};
  if (workspace() == Workspace::prepare) place = manualPlaceOf(prepareStep());
  if (workspace() == Workspace::treat) place = manualPlaceOf(*findChild<TreatSide*>(), treat_);
  if (workspace() == Workspace::review) place = manualPlaceOf(review_workspace_->page());
  HelpWindow::of(*this).showPage(place.page, place.heading);
}

std::vector<ShortcutLine> MainWindow::shortcuts() const {
  const QString names[] = {tr("Prepare"), tr("Plan"), tr("Treat"), tr("Review")};
  std::vector<std::pair<const QWidget*, QString>> pages;
  for (int i = 0; i < stack_->count(); ++i) pages.emplace_back(stack_->widget(i), names[i]);
  for (const auto* help : findChildren<HelpWindow*>()) pages.emplace_back(help, tr("Help"));
  return shortcutsOf(*this, pages);
}

}  // namespace facenav::ui
