// The menus of the main window, and the window for setting up a camera pair.

#include <QFileDialog>
#include <QMenuBar>

#include "main_window.h"
#include "setup/setup_window.h"
#include "widgets/task_bar.h"
#include "workspaces/prepare/prepare_workspace.h"

namespace facenav::ui {

void MainWindow::setUpCameras(const QString& rig) {
  if (treat_.isRunning())
    return task_bar_->showMessage(tr("end the guidance first: the cameras are in use"), true);
  if (auto preview = treat_.cameras().release()) preview.reset();  // a camera can be opened only once
  auto* window = new SetupWindow(services_, this);
  window->setAttribute(Qt::WA_DeleteOnClose);
  window->setWindowModality(Qt::WindowModal);
  window->resize(size());
  connect(window, &SetupWindow::kept, &treat_.cameras(), &CamerasPresenter::chooseRig);
  window->show();
  if (!rig.isEmpty()) window->openKept(rig);
}

void MainWindow::addMenus() {
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
  file->addAction(tr("&Set up the cameras\u2026"), this, [this] { setUpCameras(); });
  file->addSeparator();
  file->addAction(tr("&Quit"), this, &QWidget::close, QKeySequence::Quit);
  auto* view = menuBar()->addMenu(tr("&View"));
  auto* full = view->addAction(tr("&Full screen"), this,
                               [this] { setWindowState(windowState() ^ Qt::WindowFullScreen); });
  full->setShortcut(Qt::Key_F11);
}

}  // namespace facenav::ui
