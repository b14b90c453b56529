#pragma once
// MainWindow: the workstation: header (case, state), four workspaces, task bar. After a restart it restores
// case, workspace, step, how the brain is drawn, recording and target; never an alignment.

#include <QMainWindow>

#include "plan/cortex_presenter.h"
#include "plan/place_presenter.h"
#include "plan/plan_presenter.h"
#include "prepare/archive_presenter.h"
#include "prepare/edit_presenter.h"
#include "prepare/prepare_presenter.h"
#include "prepare/prepare_queue.h"
#include "prepare/sign_off_presenter.h"
#include "prepare/worklist_presenter.h"
#include "review/replay_presenter.h"
#include "review/review_presenter.h"
#include "shell/edit_menu.h"
#include "shell/shortcut_list.h"
#include "treat/treat_presenter.h"

class QStackedWidget;
class QButtonGroup;

namespace facenav::ui {

class WindowHeader;
class TaskBar;
class PrepareWorkspace;
class ReviewWorkspace;
class TreatWorkspace;

enum class PrepareStep;
enum class Workspace { prepare, plan, treat, review };

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
  /// Opens the window that sets up a camera pair; `rig`: a kept pair to check. Live pictures stop meanwhile.
  void setUpCameras(const QString& rig = {});
  /// The folder that the worklist shows and that new cases go to.
  void setCasesFolder(const QString& folder);
  /// Allows treatment without a sign-off; recorded in the case when it opens.
  void overrideSignOff(const QString& by, const QString& reason);
  /// Opens a case on the check page.
  void openCase(const QString& folder);
  /// Opens a case on the given page of Prepare.
  void openCaseAt(const QString& folder, PrepareStep step);
  /// Opens a recording when the case is open, then aligns; starts guidance if `then_guides`.
  void play(const QString& recording, bool then_guides = false);
  /// Opens what was open last time (QSettings), also after a crash. Reports if guidance was running then.
  void restoreLast();
  /// True if no task runs and what play() started has begun or failed.
  bool isSettled() const;
  const TaskRunner& tasks() const { return tasks_; }
  PrepareQueue& queue() { return queue_; }
  const WorklistPresenter& worklist() const { return worklist_; }
  ReviewPresenter& review() { return review_; }
  ReplayPresenter& replay() { return replay_; }
  /// All keyboard shortcuts of the window, by workspace.
  std::vector<ShortcutLine> shortcuts() const;
  /// Shows what these files of other programs would bring into the open case; it asks for files if there are
  /// none.
  void importOther(QStringList files = {});
  /// Opens the window that writes targets and pulses for another program.
  void exportOther();
  /// Takes what was dropped: files of other programs on Plan and Review, an electric field on Plan, a case, a
  /// recording, or a scan.
  void take(const QStringList& dropped_paths);
  /// Opens the manual where it describes the page in view.
  void showHelp();

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void closeEvent(QCloseEvent* event) override;

 private:
  void connectWords();
  void connectPrepare();
  void connectSteps(TreatWorkspace& treat_workspace);
  QWidget* makeNavigation();
  void addMenus();
  void addFileMenu();
  void addViewMenu();
  void addTextSizes(QMenu& sizes);
  void addLanguages(QMenu& menu);
  void addHelpMenu();
  PageEdits pageEdits();
  void resetLayout();
  void calibrateProjector();
  void showCaseWords();
  void showLive(const ReadOut& read_out);
  void goOnPlaying();
  void takeScan(const QString& path);
  void importField(const QString& file, const QString& surface, bool may_be_scan);
  void showImported(const QString& words, bool has_targets, const QString& session);
  void holdQueue();
  void remember();
  void goOnRestoring();
  void askBeforeClosing();
  void showEnded(const QString& session);

  static constexpr QSize kUsualSize{1480, 920};
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
  ReviewPresenter review_;
  ReplayPresenter replay_;
  PrepareWorkspace* prepare_workspace_;
  ReviewWorkspace* review_workspace_;
  QStackedWidget* stack_;
  QButtonGroup* navigation_;
  WindowHeader* header_;
  TaskBar* task_bar_;
  QString to_play_, recording_to_restore_, target_to_restore_;
  std::optional<PrepareStep> step_to_restore_, step_on_open_;
  std::optional<Override> to_override_;
  bool is_starting_ = false, then_guides_ = false, is_closing_ = false, is_remembering_ = false,
       was_guiding_ = false;
};

}  // namespace facenav::ui
