#pragma once
// Review: the sessions of the case, the pulses of one of them, and three pages beside them: pulses in 3-D
// with charts, replay, comparison of two sessions, the report.

#include <QWidget>

#include "review/replay_presenter.h"
#include "review/review_presenter.h"

class QButtonGroup;
class QCheckBox;
class QPushButton;
class QSplitter;
class QStackedWidget;

namespace facenav::ui {

class ReportPage;
class SessionsPanel;

enum class ReviewPage { pulses, replay, compare, report };

class ReviewWorkspace : public QWidget {
  Q_OBJECT

 public:
  ReviewWorkspace(ReviewPresenter& presenter, ReplayPresenter& replay, CaseModel& model,
                  QWidget* parent = nullptr);
  void setPage(ReviewPage page);
  ReviewPage page() const;

 protected:
  void showEvent(QShowEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  QWidget* makeHead();
  QWidget* makeFiles();
  void fitSessions();
  void chooseMeps();
  void showState();

  ReviewPresenter& presenter_;
  CaseModel& model_;
  QSplitter* split_;
  SessionsPanel* sessions_;
  bool was_moved_ = false;  // the user chose where the halves meet
  QStackedWidget* pages_;
  ReportPage* report_page_;
  QButtonGroup* tabs_;
  QPushButton *from_home_, *meps_, *report_;
  QCheckBox* with_name_;
};

}  // namespace facenav::ui
