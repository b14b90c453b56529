#pragma once
// ComparePage: compares the chosen session with another one: the coil's return error, target by target.

#include <QWidget>

#include "review/review_presenter.h"

class QComboBox;
class QLabel;
class QTableWidget;

namespace facenav::ui {

class ComparePage : public QWidget {
  Q_OBJECT

 public:
  explicit ComparePage(ReviewPresenter& presenter, QWidget* parent = nullptr);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void showSessions();
  void showComparison();

  ReviewPresenter& presenter_;
  QComboBox* earlier_;
  QTableWidget* table_;
  QLabel* words_;
};

}  // namespace facenav::ui
