// The Help menu of the main window: help for the page in view, all shortcuts, About.

#include <QMenuBar>
#include <QStackedWidget>

#include "prepare/prepare_workspace.h"
#include "shell/about_words.h"
#include "shell/help_window.h"
#include "shell/main_window.h"
#include "shell/shortcut_list.h"

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

/// Opens the manual where it describes the page in view.
void MainWindow::showHelp() {
  auto& help = HelpWindow::of(*this);
  const QString in_the_window = "in-the-window";
  switch (workspace()) {
    case Workspace::prepare:
      return help.showPage("prepare.md", prepareStep() == PrepareStep::archive
                                             ? "fetch-a-series-from-the-archive-facenav-pacs"
                                             : in_the_window);
    case Workspace::plan:
      return help.showPage("plan.md", in_the_window);
    case Workspace::treat:
      return help.showPage("treat.md", in_the_window);
    case Workspace::review:
      return help.showPage("review.md", in_the_window);
  }
}

std::vector<ShortcutLine> MainWindow::shortcuts() const {
  const QString names[] = {tr("Prepare"), tr("Plan"), tr("Treat"), tr("Review")};
  std::vector<std::pair<const QWidget*, QString>> pages;
  for (int i = 0; i < stack_->count(); ++i) pages.emplace_back(stack_->widget(i), names[i]);
  for (const auto* help : findChildren<HelpWindow*>()) pages.emplace_back(help, tr("Help"));
  return shortcutsOf(*this, pages);
}

}  // namespace facenav::ui
