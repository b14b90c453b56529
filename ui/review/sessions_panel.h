#pragma once
// SessionsPanel: the sessions of the case with their quality at a glance, and the pulses of the chosen one as
// a table that can be sorted; pulses are excluded with a reason, or included again.

#include <QWidget>

#include "review/pulse_table.h"

class QLabel;
class QLineEdit;
class QPushButton;
class QSortFilterProxyModel;
class QTableView;
class QTableWidget;

namespace facenav::ui {

class SessionsPanel : public QWidget {
  Q_OBJECT

 public:
  explicit SessionsPanel(ReviewPresenter& presenter, QWidget* parent = nullptr);
  /// Width at which no column of the sessions is cut, px.
  int wantedWidth() const;

 signals:
  /// The marked pulse is to be shown in the replay.
  void replayWanted();

 private:
  void makeSessions();
  void makePulses();
  void fitPulseColumns();
  QWidget* makeEdits();
  void showSessions();
  void showChosen();
  void showState();
  void showMarked();
  void showMenu(const QPoint& at);
  void excludeChosen();
  void typeMep(const QModelIndex& row);
  std::vector<int> chosen(bool are_excluded) const;
  QString by() const;

  ReviewPresenter& presenter_;
  PulseTable* table_;
  QSortFilterProxyModel* sorted_;
  QTableWidget* sessions_;
  QTableView* pulses_;
  QLabel* words_;
  QLineEdit *reason_, *by_;
  QPushButton *exclude_, *include_, *undo_, *redo_;
  bool is_filling_ = false;
};

}  // namespace facenav::ui
