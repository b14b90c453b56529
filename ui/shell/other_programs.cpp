// What is dropped on the main window, and files of other programs: to be taken in, and to be written.

#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QMimeData>

#include "facenav/plan/other_files.h"
#include "plan/export_window.h"
#include "plan/field_import_window.h"
#include "plan/import_window.h"
#include "prepare/prepare_workspace.h"
#include "shell/main_window.h"
#include "shell/task_bar.h"

namespace facenav::ui {

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  QStringList paths;
  for (const QUrl& url : event->mimeData()->urls())
    if (const QString path = url.toLocalFile(); !path.isEmpty()) paths << path;
  take(paths);
}

/// A page of Prepare or Treat takes no file of another program: there it means a scan. A field is taken where
/// targets are, in Plan.
void MainWindow::take(const QStringList& paths) {
  const bool takes_others = workspace() == Workspace::plan || workspace() == Workspace::review;
  QStringList others, unknown;
  QString field;
  bool may_be_scan = false;
  for (const QString& path : paths) {
    const bool is_ours = QFileInfo::exists(path + "/case.json") || QFileInfo::exists(path + "/stereo.yml");
    if (is_ours || !takes_others) {
      takeScan(path);
      continue;
    }
    const auto found = steps::filesAt(path.toStdString());
    for (const auto& file : found.others) others << QString::fromStdString(file.string());
    const bool is_field =
        !found.fields.empty() && field.isEmpty() && model_.isOpen() && workspace() == Workspace::plan;
    if (is_field) {
      field = path;
      may_be_scan = found.may_be_scan;
    } else if (found.may_be_scan) {
      takeScan(path);
    } else if (found.others.empty()) {
      unknown << path;
    }
  }
  if (!field.isEmpty() && unknown.size() == 1 && unknown.front().endsWith(".gii", Qt::CaseInsensitive))
    importField(field, unknown.takeFirst(), may_be_scan);
  else if (!field.isEmpty())
    importField(field, {}, may_be_scan);
  for (const QString& path : unknown)
    task_bar_->showMessage(
        tr("%1 is no file of another navigator, no case and no scan").arg(QFileInfo(path).fileName()), true);
  if (!others.isEmpty()) importOther(others);
}

void MainWindow::importField(const QString& file, const QString& surface, bool may_be_scan) {
  if (auto* shown = findChild<FieldImportWindow*>()) shown->close();
  auto* window = new FieldImportWindow(model_, plan_, may_be_scan, this);
  connect(window, &FieldImportWindow::takenIn, this,
          [this](const QString& words) { task_bar_->showMessage(words, false); });
  connect(window, &FieldImportWindow::scanMeant, this, &MainWindow::takeScan);
  window->open(file, surface);
  window->show();
  window->activateWindow();
}

/// Opens a case, passes a recording to Treat, and queues anything else to become a case.
void MainWindow::takeScan(const QString& path) {
  if (QFileInfo::exists(path + "/case.json")) return openCase(path);
  if (QFileInfo::exists(path + "/stereo.yml")) {
    setWorkspace(Workspace::treat);
    return treat_.openRecording(path);
  }
  setPrepareStep(PrepareStep::worklist);
  queue_.add(inputOf(path));
}

void MainWindow::importOther(QStringList files) {
  if (!model_.isOpen())
    return task_bar_->showMessage(tr("open the case first that the targets belong to"), true);
  if (files.isEmpty())
    files = QFileDialog::getOpenFileNames(this, tr("Import targets from another navigator"));
  if (files.isEmpty()) return;
  if (auto* shown = findChild<ImportWindow*>()) shown->close();  // one preview at a time
  auto* window = new ImportWindow(model_, plan_, this);
  connect(window, &ImportWindow::refused, this,
          [this](const QString& words) { task_bar_->showMessage(words, true); });
  connect(window, &ImportWindow::broughtIn, this, &MainWindow::showImported);
  window->open(files);
}

/// Shows what came in: targets on Plan; pulses on Review, if they came alone or the user is there.
void MainWindow::showImported(const QString& words, bool has_targets, const QString& session) {
  const bool stays = workspace() == Workspace::review && !session.isEmpty();
  setWorkspace(has_targets && !stays ? Workspace::plan : Workspace::review);
  if (!session.isEmpty()) {
    review_.refresh();
    review_.choose(session);
  }
  task_bar_->showMessage(words, false);
}

void MainWindow::exportOther() {
  if (!model_.isOpen()) return task_bar_->showMessage(tr("open the case first that shall be exported"), true);
  if (auto* shown = findChild<ExportWindow*>()) shown->close();
  const QString session = workspace() == Workspace::review ? review_.chosen() : QString();
  auto* window = new ExportWindow(model_, session, services_.storeInArchive, this);
  connect(window, &ExportWindow::written, this,
          [this](const QString& words) { task_bar_->showMessage(words, false); });
  window->show();
  window->activateWindow();
}

}  // namespace facenav::ui
