#pragma once
// Step 3, Check & edit: linked slices with the masks' contours, the brain, and the findings of the
// preparation.

#include <QWidget>

#include "prepare/edit_presenter.h"
#include "prepare/prepare_presenter.h"

class QListWidget;

namespace facenav::ui {

class LinkedViews;

class CheckPage : public QWidget {
  Q_OBJECT

 public:
  CheckPage(PreparePresenter& presenter, EditPresenter& edit, CaseModel& model, QWidget* parent = nullptr);
  void lookAt(const Point<Mri>& at);

 signals:
  /// The user continues to the sign-off.
  void goOn();

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  QWidget* makeFindingsPanel();
  void showCase();
  void showContours();
  void showFindings();

  PreparePresenter& presenter_;
  EditPresenter& edit_;
  CaseModel& model_;
  LinkedViews* views_;
  QListWidget* findings_;
  bool is_outdated_ = false, shows_automatic_ = false;
};

}  // namespace facenav::ui
