// The menus of the main window, and the window for setting up a camera pair.

#include <QActionGroup>
#include <QApplication>
#include <QFileDialog>
#include <QMenuBar>
#include <QScreen>
#include <QSplitter>
#include <algorithm>
#include <cmath>

#include "facenav/cameras/projector_model.h"
#include "facenav/core/error.h"
#include "prepare/prepare_workspace.h"
#include "prepare/worklist_page.h"
#include "setup/projector_code_screen.h"
#include "setup/setup_window.h"
#include "shell/appearance.h"
#include "shell/language.h"
#include "shell/linked_views.h"
#include "shell/main_window.h"
#include "shell/screenshot.h"
#include "shell/shown_words.h"
#include "shell/task_bar.h"
#include "shell/theme.h"
#include "shell/work_area.h"

namespace facenav::ui {
namespace {

/// The themes; another one holds at once, and at the next start.
void addThemes(QMenu& themes) {
  auto* group = new QActionGroup(&themes);
  const std::pair<ThemeChoice, QString> choices[] = {{ThemeChoice::dark, MainWindow::tr("&Dark")},
                                                     {ThemeChoice::light, MainWindow::tr("&Light")},
                                                     {ThemeChoice::system, MainWindow::tr("As the &system")}};
  for (const auto& [choice, words] : choices) {
    auto* action = themes.addAction(words, &themes, [choice = choice] {
      rememberTheme(choice);
      changeTheme(*qApp, choice);
    });
    action->setCheckable(true);
    action->setChecked(rememberedTheme() == choice);
    group->addAction(action);
  }
}

}  // namespace

void MainWindow::setUpCameras(const QString& rig) {
  if (treat_.isRunning())
    return task_bar_->showMessage(tr("end the guidance first: the cameras are in use"), true);
  if (!treat_.cameras().mayClose())
    return task_bar_->showMessage(
        tr("wait for the running task to end, or cancel it: it may use the cameras"), true);
  treat_.cameras().closeCameras();  // a camera can be opened only once
  auto* window = new SetupWindow(services_, this);
  window->setAttribute(Qt::WA_DeleteOnClose);
  window->setWindowModality(Qt::WindowModal);
  window->resize(size());
  connect(window, &SetupWindow::kept, &treat_.cameras(), &CamerasPresenter::chooseRig);
  window->show();
  if (!rig.isEmpty()) window->openKept(rig);
}

void MainWindow::calibrateProjector() {
  auto& live = treat_.cameras();
  if (!live.isLive())
    return task_bar_->showMessage(tr("open the calibrated cameras first (Treat, Cameras)"), true);
  const QScreen* screen = QApplication::screens().last();
  auto* window = new ProjectorCodeScreen(
      live.lastOpened()->rig, screen->size() * screen->devicePixelRatio(),
      [this] { return treat_.cameras().picture(); }, this);
  window->setAttribute(Qt::WA_DeleteOnClose);
  connect(window, &QObject::destroyed, this, [this] { activateWindow(); });
  connect(window, &ProjectorCodeScreen::sceneTaken, this, [this, window] {
    if (!window->run().result()) return;
    const QString file = QFileDialog::getSaveFileName(this, tr("Keep the projector's calibration"),
                                                      "projector.yml", tr("Calibration (*.yml)"));
    if (file.isEmpty()) return;
    try {
      cameras::writeProjector(window->run().result()->projector, file.toStdString());
      task_bar_->showMessage(shownWords(window->run().words()), false);
    } catch (const Error& error) {
      task_bar_->showMessage(shownWords(error), true);
    }
  });
  window->setGeometry(screen->geometry());
  window->showFullScreen();
}

void MainWindow::addMenus() {
  addFileMenu();
  new EditMenu(*menuBar()->addMenu(tr("&Edit")), [this] { return pageEdits(); });
  addViewMenu();
  addHelpMenu();
}

void MainWindow::addFileMenu() {
  auto* file = menuBar()->addMenu(tr("&File"));
  file->addAction(
      tr("&Open case\u2026"), this,
      [this] {
        const QString folder = QFileDialog::getExistingDirectory(this, tr("Open a case"));
        if (!folder.isEmpty()) openCase(folder);
      },
      QKeySequence::Open);
  file->addAction(
      tr("&Read DICOM folder\u2026"), this,
      [this] {
        setWorkspace(Workspace::prepare);
        prepare_workspace_->chooseInput();
      },
      Qt::CTRL + Qt::Key_I);
  file->addAction(
      tr("I&mport targets from another navigator\u2026"), this, [this] { importOther(); },
      Qt::CTRL + Qt::SHIFT + Qt::Key_I);
  file->addAction(tr("&Export for another program\u2026"), this, &MainWindow::exportOther,
                  Qt::CTRL + Qt::SHIFT + Qt::Key_E);
  file->addSeparator();
  file->addAction(tr("&Set up the cameras\u2026"), this, [this] { setUpCameras(); });
  file->addAction(tr("Calibrate the &projector\u2026"), this, &MainWindow::calibrateProjector);
  file->addSeparator();
  file->addAction(tr("&Quit"), this, &QWidget::close, QKeySequence::Quit);
}

/// What the page in view lets the Edit menu undo, redo and delete.
PageEdits MainWindow::pageEdits() {
  PageEdits edits;
  if (workspace() == Workspace::prepare && prepareStep() == PrepareStep::worklist) {
    auto& worklist = prepare_workspace_->worklistPage();
    if (worklist.canRemove())
      edits.remove = {[&worklist] { worklist.removeChosen(); }, worklist.removeWords()};
  }
  if (workspace() == Workspace::prepare && prepareStep() == PrepareStep::check) {
    if (edit_.canUndo()) edits.undo.act = [this] { edit_.undo(); };
    if (edit_.canRedo()) edits.redo.act = [this] { edit_.redo(); };
  }
  if (workspace() == Workspace::plan && model_.isOpen()) {
    if (plan_.canUndo()) edits.undo.act = [this] { plan_.undo(); };
    if (plan_.canRedo()) edits.redo.act = [this] { plan_.redo(); };
    const auto* target = plan_.active();
    if (target && !target->is_locked) edits.remove = {[this] { plan_.removeActive(); }, plan_.activeName()};
  }
  if (workspace() == Workspace::review) {
    const auto& editor = review_.editor();
    if (editor.canUndo()) edits.undo = {[this] { review_.undo(); }, shownWords(editor.undoWords())};
    if (editor.canRedo()) edits.redo = {[this] { review_.redo(); }, shownWords(editor.redoWords())};
  }
  return edits;
}

void MainWindow::addViewMenu() {
  auto* view = menuBar()->addMenu(tr("&View"));
  addTextSizes(*view->addMenu(tr("&Text size")));
  addThemes(*view->addMenu(tr("T&heme")));
  addLanguages(*view->addMenu(tr("&Language")));
  view->addAction(tr("&Reset the layout"), this, &MainWindow::resetLayout);
  auto* full = view->addAction(tr("&Full screen"), this,
                               [this] { setWindowState(windowState() ^ Qt::WindowFullScreen); });
  full->setShortcut(Qt::Key_F11);
  view->addSeparator();
  view->addAction(
      tr("&Picture of the window\u2026"), this,
      [this] {
        try {
          if (const QString words = keepScreenshot(*this); !words.isEmpty())
            task_bar_->showMessage(words, false);
        } catch (const Error& error) {
          task_bar_->showMessage(shownWords(error), true);
        }
      },
      Qt::CTRL + Qt::SHIFT + Qt::Key_S);
}

/// The sizes of text; another one holds at once, and at the next start.
void MainWindow::addTextSizes(QMenu& sizes) {
  auto* group = new QActionGroup(&sizes);
  for (const int percent : {75, 100, 125, 150, 200, 300}) {
    auto* action = sizes.addAction(tr("%1 %").arg(percent), this, [this, percent] {
      rememberTextScale(percent / 100.0);
      changeTextScale(*qApp, percent / 100.0);
    });
    action->setCheckable(true);
    action->setChecked(std::lround(100 * rememberedTextScale()) == percent);
    group->addAction(action);
  }
}

/// The languages, each by its own name. Another one holds from the next start.
void MainWindow::addLanguages(QMenu& menu) {
  auto* group = new QActionGroup(&menu);
  for (const Language& language : languages()) {
    auto* action = menu.addAction(language.name, this, [this, language] {
      rememberLanguage(language.code);
      if (language.code != languageInForce())
        task_bar_->showMessage(tr("FaceNav speaks %1 from its next start").arg(language.name), false);
    });
    action->setCheckable(true);
    action->setChecked(language.code == languageInForce());
    group->addAction(action);
  }
}

/// Gives the window its first size, each divided page its first shares, and the slices their whole pictures.
void MainWindow::resetLayout() {
  setWindowState(windowState() & ~(Qt::WindowMaximized | Qt::WindowFullScreen));
  fitIntoWorkArea(*this, kUsualSize);
  for (auto* split : findChildren<QSplitter*>()) {
    QList<int> shares;
    for (int i = 0; i < split->count(); ++i)
      shares << 1000 * std::max(1, split->widget(i)->sizePolicy().horizontalStretch());
    split->setSizes(shares);
  }
  for (auto* views : findChildren<LinkedViews*>()) views->resetSlices();
}

}  // namespace facenav::ui
