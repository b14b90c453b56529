#pragma once
// MainWindow: the workstation: header (case, state), three workspaces, task bar. After a restart case,
// workspace, step, the brain's look, recording and target are those of before; an alignment never is.

#include <QMainWindow>

#include "presenters/archive_presenter.h"
#include "presenters/cortex_presenter.h"
#include "presenters/edit_presenter.h"
#include "presenters/place_presenter.h"
#include "presenters/plan_presenter.h"
#include "presenters/prepare_presenter.h"
#include "presenters/prepare_queue.h"
#include "presenters/sign_off_presenter.h"
#include "presenters/treat_presenter.h"
#include "presenters/worklist_presenter.h"

class QLabel;
class QStackedWidget;
class QButtonGroup;

namespace facenav::ui {

class ElidedLabel;
class StatusChip;
class TaskBar;
class PrepareWorkspace;

enum class PrepareStep;
enum class Workspace { prepare, plan, treat };

class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(const Services& services, QWidget* parent = nullptr);
  ~MainWindow() override;

  void setWorkspace(Workspace workspace);
  Workspace workspace() const;
  void setPrepareStep(PrepareStep step);
  PrepareStep prepareStep() const;
  const CortexPresenter& cortex() const { return cortex_; }
  const TreatPresenter& treat() const { return treat_; }
  /// The folder that the worklist shows and new cases go to.
  void setCasesFolder(const QString& folder);
  /// Recorded in the case, once it is open: it may be treated without a sign-off.
  void overrideSignOff(const QString& by, const QString& reason);
  /// Opens a case to be checked.
  void openCase(const QString& folder);
  /// Opens a case on a step of Prepare.
  void openCaseAt(const QString& folder, PrepareStep step);
  /// Opens a recording once the case is there, aligns and starts guidance.
  void play(const QString& recording);
  /// What was open when the window was last open, closed or not (QSettings). Says so where guidance was
  /// running.
  void restoreLast();
  /// No task runs, and what play() was asked for has begun or failed.
  bool isSettled() const;
  const TaskRunner& tasks() const { return tasks_; }
  PrepareQueue& queue() { return queue_; }
  const WorklistPresenter& worklist() const { return worklist_; }

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void closeEvent(QCloseEvent* event) override;

 private:
  QWidget* makeHeader();
  QWidget* makeNavigation();
  void addMenus();
  void showCaseWords();
  void showLive(const ReadOut& read_out);
  void goOnPlaying();
  void take(const QString& dropped_path);
  void holdQueue();
  void remember();
  void goOnRestoring();

  Services services_;
  TaskRunner tasks_;
  CaseModel model_;
  PrepareQueue queue_;
  WorklistPresenter worklist_;
  ArchivePresenter archive_;
  PreparePresenter prepare_;
  SignOffPresenter sign_off_;
  EditPresenter edit_;
  CortexPresenter cortex_;
  PlacePresenter place_;
  PlanPresenter plan_;
  TreatPresenter treat_;
  PrepareWorkspace* prepare_workspace_;
  QStackedWidget* stack_;
  QButtonGroup* navigation_;
  ElidedLabel* case_words_;
  QLabel* timing_;
  StatusChip *cameras_, *face_, *coil_;
  TaskBar* task_bar_;
  QString to_play_, recording_to_restore_, target_to_restore_;
  std::optional<PrepareStep> step_to_restore_, step_on_open_;
  std::optional<Override> to_override_;
  bool is_starting_ = false, is_remembering_ = false, was_guiding_ = false;
};

}  // namespace facenav::ui
