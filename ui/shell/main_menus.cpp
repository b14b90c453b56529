// The menus of the main window, and the window for setting up a camera pair.

#include <QApplication>
#include <QFileDialog>
#include <QMenuBar>
#include <QScreen>

#include "facenav/cameras/projector_model.h"
#include "facenav/core/error.h"
#include "prepare/prepare_workspace.h"
#include "setup/projector_code_screen.h"
#include "setup/setup_window.h"
#include "shell/main_window.h"
#include "shell/task_bar.h"

namespace facenav::ui {

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
      task_bar_->showMessage(QString::fromStdString(window->run().words()), false);
    } catch (const Error& error) {
      task_bar_->showMessage(QString::fromUtf8(error.what()), true);
    }
  });
  window->setGeometry(screen->geometry());
  window->showFullScreen();
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
  file->addAction(tr("Calibrate the &projector\u2026"), this, &MainWindow::calibrateProjector);
  file->addSeparator();
  file->addAction(tr("&Quit"), this, &QWidget::close, QKeySequence::Quit);
  auto* view = menuBar()->addMenu(tr("&View"));
  auto* full = view->addAction(tr("&Full screen"), this,
                               [this] { setWindowState(windowState() ^ Qt::WindowFullScreen); });
  full->setShortcut(Qt::Key_F11);
}

}  // namespace facenav::ui
