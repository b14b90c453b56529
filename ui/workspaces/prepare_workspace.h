#pragma once
// Prepare: series list, linked slices with the masks' contours and the brain view, findings.

#include <QWidget>

#include "presenters/prepare_presenter.h"

class QListWidget;
class QPushButton;

namespace facenav::ui {

class LinkedViews;

class PrepareWorkspace : public QWidget {
  Q_OBJECT

 public:
  PrepareWorkspace(PreparePresenter& presenter, CaseModel& model, QWidget* parent = nullptr);
  /// Asks for a folder or file to read.
  void chooseInput();

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  QWidget* makeSeriesPanel();
  QWidget* makeFindingsPanel();
  void showLines();
  void showCase();
  void prepareChosen();

  PreparePresenter& presenter_;
  CaseModel& model_;
  QListWidget* series_;
  QListWidget* findings_;
  QPushButton* prepare_;
  LinkedViews* views_;
  bool is_outdated_ = false;
};

}  // namespace facenav::ui
