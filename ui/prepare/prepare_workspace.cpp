#include "prepare/prepare_workspace.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "prepare/archive_page.h"
#include "prepare/check_page.h"
#include "prepare/series_page.h"
#include "prepare/sign_off_page.h"
#include "prepare/worklist_page.h"
#include "shell/words_of_button.h"

namespace facenav::ui {

PrepareWorkspace::PrepareWorkspace(PreparePresenter& presenter, WorklistPresenter& worklist,
                                   PrepareQueue& queue, ArchivePresenter& archive, SignOffPresenter& sign_off,
                                   EditPresenter& edit, CaseModel& model, QWidget* parent)
    : QWidget(parent),
      presenter_(presenter),
      sign_off_(sign_off),
      model_(model),
      pages_(new QStackedWidget(this)),
      steps_(new QButtonGroup(this)),
      series_page_(new SeriesPage(presenter, this)),
      worklist_page_(new WorklistPage(worklist, queue, this)) {
  auto* check_page = new CheckPage(presenter, edit, model, this);
  auto* sign_off_page = new SignOffPage(sign_off, model, this);
  auto* archive_page = new ArchivePage(archive, this);
  for (QWidget* page : {static_cast<QWidget*>(worklist_page_), static_cast<QWidget*>(series_page_),
                        static_cast<QWidget*>(check_page), static_cast<QWidget*>(sign_off_page),
                        static_cast<QWidget*>(archive_page)})
    pages_->addWidget(page);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(10, 8, 10, 10);
  column->addWidget(makeSteps());
  column->addWidget(pages_, 1);
  connect(worklist_page_, &WorklistPage::caseChosen, this, &PrepareWorkspace::caseChosen);
  connect(worklist_page_, &WorklistPage::signOffWanted, this, &PrepareWorkspace::signOffWanted);
  connect(worklist_page_, &WorklistPage::inputChosen, this, [this](const QString& input) {
    presenter_.openInput(input);
    setStep(PrepareStep::series);
  });
  connect(series_page_, &SeriesPage::queued, this, [this] { setStep(PrepareStep::worklist); });
  connect(series_page_, &SeriesPage::archiveWanted, this, [this] { setStep(PrepareStep::archive); });
  connect(archive_page, &ArchivePage::left, this, [this] { setStep(PrepareStep::series); });
  connect(archive_page, &ArchivePage::queued, this, [this] { setStep(PrepareStep::worklist); });
  connect(check_page, &CheckPage::goOn, this, [this] { setStep(PrepareStep::sign_off); });
  connect(sign_off_page, &SignOffPage::lookCloser, this, [this, check_page](double x, double y, double z) {
    setStep(PrepareStep::check);
    check_page->lookAt({x, y, z});
  });
  connect(&model_, &CaseModel::opened, this, &PrepareWorkspace::showSteps);
  connect(&sign_off_, &SignOffPresenter::changed, this, &PrepareWorkspace::showSteps);
  setStep(PrepareStep::worklist);
}

QWidget* PrepareWorkspace::makeSteps() {
  auto* bar = new QWidget(this);
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(0, 0, 0, 4);
  const QString tips[4] = {tr("cases and what is being prepared (Alt+1)"), tr("series of a folder (Alt+2)"),
                           tr("slices with contours, findings (Alt+3)"),
                           tr("take the model as seen, by name (Alt+4)")};
  for (int i = 0; i < 4; ++i) {
    auto* button = new QPushButton(bar);
    button->setObjectName("step");
    button->setCheckable(true);
    button->setToolTip(tips[i]);
    button->setShortcut(QKeySequence(Qt::ALT + Qt::Key_1 + i));
    steps_->addButton(button, i);
    row->addWidget(button);
  }
  row->addStretch(1);
  connect(steps_, &QButtonGroup::idClicked, this, [this](int id) { setStep(PrepareStep(id)); });
  return bar;
}

void PrepareWorkspace::setStep(PrepareStep step) {
  pages_->setCurrentIndex(int(step));
  showSteps();
  emit stepChanged();
}

PrepareStep PrepareWorkspace::step() const { return PrepareStep(pages_->currentIndex()); }

void PrepareWorkspace::showSteps() {
  const QString names[4] = {tr("1  Worklist"), tr("2  Series"), tr("3  Check && edit"), tr("4  Sign off")};
  for (int i = 0; i < 4; ++i) {
    auto* button = steps_->button(i);
    const bool is_done = i == 3 && sign_off_.holds();
    setWords(*button, is_done ? names[i] + "  \u2713" : names[i]);
    button->setEnabled(i < 2 || model_.isOpen());
  }
  steps_->button(step() == PrepareStep::archive ? 1 : pages_->currentIndex())->setChecked(true);
}

void PrepareWorkspace::chooseInput() {
  setStep(PrepareStep::series);
  series_page_->chooseFolder();
}

}  // namespace facenav::ui
