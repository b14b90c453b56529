#pragma once
// ImportWindow: shows what files of other programs would bring into the open case, before anything is
// written: the list, the head with the coils, and what the files leave open. It does not hold up the window
// that it belongs to.

#include <QWidget>

#include "plan/import_presenter.h"

class QHBoxLayout;
class QLabel;
class QPushButton;

namespace facenav::ui {

class ImportChoices;
class ImportList;
class ImportView;

class ImportWindow : public QWidget {
  Q_OBJECT

 public:
  ImportWindow(CaseModel& model, PlanPresenter& plan, QWidget* parent);
  /// Reads the files, then shows the window. A single file that cannot be read is refused() in one line, and
  /// the window closes.
  void open(const QStringList& files);
  ImportPresenter& presenter() { return presenter_; }

 signals:
  void refused(const QString& words);
  /// See ImportPresenter::broughtIn().
  void broughtIn(const QString& words, bool has_targets, const QString& session);

 private:
  QWidget* makeLeft();
  QWidget* makeRight(CaseModel& model);
  QHBoxLayout* makeButtons();
  void showRead();
  void showChosen();
  void showState();

  ImportPresenter presenter_;
  ImportList* list_;
  ImportView* view_;
  ImportChoices* choices_;
  QLabel *summary_, *detail_, *fault_;
  QPushButton *all_, *none_, *bring_in_;
  bool was_shown_ = false;
};

}  // namespace facenav::ui
