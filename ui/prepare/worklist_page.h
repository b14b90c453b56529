#pragma once
// Step 1, Worklist: cases, and jobs that will become cases. Type to filter, double click to open.

#include <QWidget>

#include "prepare/worklist_table.h"

class QLabel;
class QLineEdit;
class QPushButton;
class QTableView;

namespace facenav::ui {

class ElidedLabel;

class WorklistPage : public QWidget {
  Q_OBJECT

 public:
  WorklistPage(WorklistPresenter& presenter, PrepareQueue& queue, QWidget* parent = nullptr);
  /// True if a line is chosen: a case, which is deleted after a question, or a job, which is taken off the
  /// list.
  bool canRemove() const { return chosen() != nullptr; }
  void removeChosen();
  /// Name of the chosen line.
  QString removeWords() const;

 signals:
  void caseChosen(const QString& folder);
  void signOffWanted(const QString& case_folder);
  /// A job that has no case yet was chosen: show its series.
  void inputChosen(const QString& input);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QWidget* makeHead();
  QWidget* makeActions();
  void makeTable();
  void addKeys();
  void showMenu(const QPoint& at);
  void askToDelete(const WorklistRow& row);
  void openChosen();
  void labelChosen();
  void showState();
  void chooseFolder();
  /// The selected row, or null.
  const WorklistRow* chosen() const;

  WorklistPresenter& presenter_;
  PrepareQueue& queue_;
  WorklistTable* table_;
  WorklistFilter* filter_;
  QTableView* view_;
  QLineEdit* search_;
  ElidedLabel *folder_, *summary_;
  QLabel* empty_;
  QPushButton *open_, *label_, *cancel_, *retry_, *remove_;
};

}  // namespace facenav::ui
