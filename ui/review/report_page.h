#pragma once
// ReportPage: the report of the chosen session, to read in the window. The same content as report.html and
// report.pdf; made anew when the session changes.

#include <QWidget>

#include "facenav/report/session_report.h"
#include "review/review_presenter.h"

class QLabel;
class QTextBrowser;
class QTextDocument;

namespace facenav::ui {

class ReportPage : public QWidget {
  Q_OBJECT

 public:
  ReportPage(ReviewPresenter& presenter, CaseModel& model, QWidget* parent = nullptr);
  /// Adds the case's label to the report, or leaves it out.
  void setWithName(bool has_name);

 protected:
  void showEvent(QShowEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void make();
  void fitWords();
  void show(const report::SessionReport& report);

  ReviewPresenter& presenter_;
  CaseModel& model_;
  TaskRunner maker_;
  QLabel* words_;
  QTextBrowser* text_;
  QTextDocument* document_ = nullptr;  // the report that is shown
  bool has_name_ = false, is_outdated_ = true;
};

}  // namespace facenav::ui
