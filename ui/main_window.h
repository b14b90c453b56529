#pragma once
// MainWindow: the workstation: header (case, state), three workspaces, task bar. Opens case, recording and
// workspace that were open when it was closed.

#include <QMainWindow>

#include "presenters/plan_presenter.h"
#include "presenters/prepare_presenter.h"
#include "presenters/treat_presenter.h"

class QLabel;
class QStackedWidget;
class QButtonGroup;

namespace facenav::ui {

class StatusChip;
class TaskBar;
class PrepareWorkspace;

enum class Workspace { prepare, plan, treat };

class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(const Services& services, QWidget* parent = nullptr);
  ~MainWindow() override;

  void setWorkspace(Workspace workspace);
  void openCase(const QString& folder);
  /// Opens a recording once the case is there, aligns and starts guidance.
  void play(const QString& recording);
  /// What was open when the window was closed last (QSettings).
  void restoreLast();
  /// No task runs, and what play() was asked for has begun or failed.
  bool isSettled() const;
  const TaskRunner& tasks() const { return tasks_; }

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

  Services services_;
  TaskRunner tasks_;
  CaseModel model_;
  PreparePresenter prepare_;
  PlanPresenter plan_;
  TreatPresenter treat_;
  PrepareWorkspace* prepare_workspace_;
  QStackedWidget* stack_;
  QButtonGroup* navigation_;
  QLabel *case_words_, *timing_;
  StatusChip *cameras_, *face_, *coil_;
  TaskBar* task_bar_;
  QString to_play_;
  bool is_starting_ = false;
};

}  // namespace facenav::ui
