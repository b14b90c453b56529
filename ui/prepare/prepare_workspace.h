#pragma once
// Prepare: the radiographer's four steps, one page each: 1 Worklist, 2 Series, 3 Check & edit, 4 Sign off.

#include <QWidget>

#include "prepare/archive_presenter.h"
#include "prepare/edit_presenter.h"
#include "prepare/prepare_presenter.h"
#include "prepare/sign_off_presenter.h"
#include "prepare/worklist_presenter.h"

class QButtonGroup;
class QStackedWidget;

namespace facenav::ui {

class CheckPage;
class SeriesPage;
class WorklistPage;

/// `archive` belongs to step 2.
enum class PrepareStep { worklist, series, check, sign_off, archive };

class PrepareWorkspace : public QWidget {
  Q_OBJECT

 public:
  PrepareWorkspace(PreparePresenter& presenter, WorklistPresenter& worklist, PrepareQueue& queue,
                   ArchivePresenter& archive, SignOffPresenter& sign_off, EditPresenter& edit,
                   CaseModel& model, QWidget* parent = nullptr);
  void setStep(PrepareStep step);
  PrepareStep step() const;
  /// Asks for a folder to read.
  void chooseInput();
  WorklistPage& worklistPage() { return *worklist_page_; }

 signals:
  void stepChanged();
  void caseChosen(const QString& folder);
  void signOffWanted(const QString& case_folder);

 private:
  QWidget* makeSteps();
  void showSteps();

  PreparePresenter& presenter_;
  SignOffPresenter& sign_off_;
  CaseModel& model_;
  QStackedWidget* pages_;
  QButtonGroup* steps_;
  SeriesPage* series_page_;
  WorklistPage* worklist_page_;
};

}  // namespace facenav::ui
