#include "shell/main_window.h"

#include <QButtonGroup>
#include <QCloseEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QMessageBox>
#include <QPushButton>
#include <QScrollArea>
#include <QSettings>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>
#include <utility>

#include "plan/plan_workspace.h"
#include "prepare/prepare_workspace.h"
#include "review/review_workspace.h"
#include "shell/appearance.h"
#include "shell/task_bar.h"
#include "shell/window_header.h"
#include "shell/work_area.h"
#include "treat/treat_workspace.h"

namespace facenav::ui {
namespace {

const char* const kGeometry = "last/geometry";
const char* const kCase = "last/case";
const char* const kWorkspace = "last/workspace";
const char* const kStep = "last/step";
const char* const kRecording = "last/recording";
const char* const kTarget = "last/target";
const char* const kGuiding = "last/guiding";

}  // namespace

MainWindow::MainWindow(const Services& services, QWidget* parent)
    : QMainWindow(parent),
      services_(services),
      queue_(services_),
      worklist_(queue_),
      archive_(services_, queue_),
      prepare_(services_, model_, tasks_, queue_),
      sign_off_(model_, tasks_),
      edit_(model_, tasks_),
      cortex_(model_),
      place_(services_, model_),
      plan_(model_),
      treat_(services_, model_, tasks_),
      review_(model_),
      replay_(review_, model_),
      stack_(new QStackedWidget(this)) {
  setWindowTitle(tr("FaceNav"));
  setAcceptDrops(true);
  prepare_workspace_ =
      new PrepareWorkspace(prepare_, worklist_, queue_, archive_, sign_off_, edit_, model_, stack_);
  auto* treat_workspace = new TreatWorkspace(treat_, model_, stack_);
  stack_->addWidget(prepare_workspace_);
  auto* plan_workspace = new PlanWorkspace(plan_, place_, cortex_, model_, stack_);
  plan_workspace->buildFieldsBy(queue_);
  plan_workspace->showOffersOf(treat_.offers());
  stack_->addWidget(plan_workspace);
  stack_->addWidget(treat_workspace);
  review_workspace_ = new ReviewWorkspace(review_, replay_, model_, stack_);
  stack_->addWidget(review_workspace_);
  task_bar_ = new TaskBar(tasks_, this);
  header_ = new WindowHeader(this);
  auto* centre = new QWidget(this);
  auto* column = new QVBoxLayout(centre);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(header_);
  auto* pages = new QWidget(this);
  auto* row = new QHBoxLayout(pages);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  row->addWidget(makeNavigation());
  row->addWidget(stack_, 1);
  auto* page_area = scrolledIfSmall(pages, this);
  page_area->setObjectName("page_area");
  column->addWidget(page_area, 1);
  column->addWidget(task_bar_);
  setCentralWidget(centre);
  addMenus();
  fitIntoWorkArea(*this, kUsualSize);
  connectWords();
  connectPrepare();
  connectSteps(*treat_workspace);
  setWorkspace(Workspace::prepare);
  showCaseWords();
  is_remembering_ = true;
  task_bar_->showMessage(tr("Drop DICOM folders, NIfTI files or a case anywhere."), false);
}

/// Pages that are hidden still ask their presenters, which end before the pages do.
MainWindow::~MainWindow() { hide(); }

void MainWindow::connectWords() {
  connect(&model_, &CaseModel::opened, this, &MainWindow::showCaseWords);
  connect(&treat_, &TreatPresenter::changed, this, &MainWindow::showCaseWords);
  connect(&model_, &CaseModel::signOffChanged, this, &MainWindow::showCaseWords);
  connect(&model_, &CaseModel::opened, this, [this] {
    worklist_.setOpenCase(QString::fromStdString(model_.current().store.folder().string()));
  });
  connect(&model_, &CaseModel::labelChanged, this, &MainWindow::showCaseWords);
  const auto refuse = [this](const QString& words) { task_bar_->showMessage(words, true); };
  connect(&worklist_, &WorklistPresenter::refused, this, refuse);
  connect(&treat_, &TreatPresenter::refused, this, refuse);
  connect(&plan_, &PlanPresenter::refused, this, refuse);
  connect(&edit_, &EditPresenter::refused, this, refuse);
  connect(&review_, &ReviewPresenter::refused, this, refuse);
  connect(&replay_, &ReplayPresenter::refused, this, refuse);
  const auto say = [this](const QString& words) { task_bar_->showMessage(words, false); };
  connect(&review_, &ReviewPresenter::said, this, say);
  connect(&worklist_, &WorklistPresenter::said, this, say);
}

void MainWindow::connectPrepare() {
  connect(
      &worklist_, &WorklistPresenter::labelled, this, [this](const QString& folder, const QString& label) {
        if (model_.isOpen() &&
            QFileInfo(folder) == QFileInfo(QString::fromStdString(model_.current().store.folder().string())))
          model_.setLabel(label);
      });
  connect(prepare_workspace_, &PrepareWorkspace::caseChosen, this, &MainWindow::openCase);
  connect(prepare_workspace_, &PrepareWorkspace::signOffWanted, this,
          [this](const QString& folder) { openCaseAt(folder, PrepareStep::sign_off); });
  connect(&queue_, &PrepareQueue::prepared, this, [this](const QString&, const QString& case_id) {
    if (!tasks_.isRunning()) task_bar_->showMessage(tr("case %1 is prepared: check it").arg(case_id), false);
  });
  connect(&queue_, &PrepareQueue::choiceNeeded, this, [this](int id) {
    if (!tasks_.isRunning())
      task_bar_->showNotice(
          tr("%1: %2, choose one").arg(queue_.job(id)->title, choiceWords(*queue_.job(id))));
  });
}

/// Connects the steps. Must follow connectWords(): signals that show come before those that restore.
void MainWindow::connectSteps(TreatWorkspace& treat_workspace) {
  connect(&treat_, &TreatPresenter::sessionEnded, this, &MainWindow::showEnded);
  auto& offers = treat_.offers();
  offers.keepBy(
      [this](const guidance::TreatmentPlan& plan, const QString& taken) { plan_.takePlan(plan, taken); });
  connect(&offers, &OffersPresenter::shown, this, [this] { setWorkspace(Workspace::plan); });
  connect(&treat_, &TreatPresenter::changed, this, &MainWindow::holdQueue);
  connect(&treat_, &TreatPresenter::changed, this, &MainWindow::remember);
  connect(prepare_workspace_, &PrepareWorkspace::stepChanged, this, &MainWindow::remember);
  connect(&model_, &CaseModel::opened, this, [this] {
    const auto step = step_to_restore_ ? step_to_restore_ : step_on_open_;
    step_to_restore_.reset();  // first, because setStep() remembers the new step
    if (step) prepare_workspace_->setStep(*step);
    if (to_override_) treat_.overrideSignOff(to_override_->by, to_override_->reason);
    to_override_.reset();
  });
  connect(&treat_.cameras(), &CamerasPresenter::setUpWanted, this, &MainWindow::setUpCameras);
  connect(&treat_workspace, &TreatWorkspace::shown, this, &MainWindow::showLive);
  connect(&tasks_, &TaskRunner::succeeded, this, &MainWindow::goOnPlaying);
  connect(&tasks_, &TaskRunner::succeeded, this, &MainWindow::goOnRestoring);
  connect(&tasks_, &TaskRunner::failed, this, [this] {
    to_play_.clear();
    recording_to_restore_.clear();
    is_starting_ = false;
  });
}

QWidget* MainWindow::makeNavigation() {
  auto* bar = new QFrame(this);
  bar->setObjectName("navigation");
  auto* column = new QVBoxLayout(bar);
  column->setContentsMargins(8, 12, 8, 12);
  navigation_ = new QButtonGroup(this);
  const QString names[4] = {tr("\u25a3\nPrepare"), tr("\u25ce\nPlan"), tr("\u271a\nTreat"),
                            tr("\u2261\nReview")};
  const QString tips[4] = {tr("MRI to case: series, masks, brain (Ctrl+1)"),
                           tr("targets on the cortex (Ctrl+2)"), tr("align and guide the coil (Ctrl+3)"),
                           tr("what was given, replay, report (Ctrl+4)")};
  for (int i = 0; i < 4; ++i) {
    auto* button = new QToolButton(bar);
    button->setText(names[i]);
    button->setToolTip(tips[i]);
    button->setCheckable(true);
    button->setShortcut(QKeySequence(Qt::CTRL + Qt::Key_1 + i));
    whenTextScales(button, [button] { button->setFixedSize(sized(84), sized(68)); });
    navigation_->addButton(button, i);
    column->addWidget(button);
  }
  column->addStretch(1);
  connect(navigation_, &QButtonGroup::idClicked, this, [this](int id) { setWorkspace(Workspace(id)); });
  return bar;
}

void MainWindow::setWorkspace(Workspace workspace) {
  stack_->setCurrentIndex(int(workspace));
  navigation_->button(int(workspace))->setChecked(true);
  header_->showLiveStates(workspace == Workspace::treat);
  remember();
}

Workspace MainWindow::workspace() const { return Workspace(stack_->currentIndex()); }

PrepareStep MainWindow::prepareStep() const { return prepare_workspace_->step(); }

void MainWindow::setPrepareStep(PrepareStep step) {
  if (step_to_restore_) step_to_restore_ = step;  // the last session's case is still being opened
  setWorkspace(Workspace::prepare);
  prepare_workspace_->setStep(step);
}

void MainWindow::setCasesFolder(const QString& folder) { worklist_.setFolder(folder); }

void MainWindow::overrideSignOff(const QString& by, const QString& reason) {
  to_override_ = Override{by, reason};
}

/// Preparing uses every core, so no job starts during a treatment.
void MainWindow::holdQueue() {
  queue_.setHeld(treat_.isRunning());
  if (treat_.isRunning()) stack_->findChild<PlanWorkspace*>()->stopBuilding();
}

void MainWindow::openCase(const QString& folder) { openCaseAt(folder, PrepareStep::check); }

void MainWindow::openCaseAt(const QString& folder, PrepareStep step) {
  QSettings().setValue(kCase, QFileInfo(folder).absoluteFilePath());
  step_on_open_ = step;
  step_to_restore_.reset();
  prepare_.openCase(folder);
}

void MainWindow::play(const QString& recording, bool then_guides) {
  to_play_ = recording;
  then_guides_ = then_guides;
  goOnPlaying();
}

/// Goes from case opened to recording opened to aligned, and started if asked. Called when each of these
/// steps ends.
void MainWindow::goOnPlaying() {
  if (to_play_.isEmpty() || tasks_.isRunning()) return;
  if (!treat_.hasRecording()) {
    treat_.openRecording(to_play_);
  } else if (model_.isOpen()) {
    to_play_.clear();
    is_starting_ = then_guides_ && model_.mayBeTreated();
    treat_.align(then_guides_);
  }
}

bool MainWindow::isSettled() const {
  return !tasks_.isRunning() && to_play_.isEmpty() &&
         (!is_starting_ || treat_.isRunning() || treat_.hasEnded());
}

void MainWindow::restoreLast() {
  const QSettings settings;
  restoreGeometry(settings.value(kGeometry).toByteArray());
  queue_.restore();
  const QString folder = settings.value(kCase).toString();
  const auto workspace = Workspace(std::clamp(settings.value(kWorkspace, 0).toInt(), 0, 3));
  const auto step = PrepareStep(std::clamp(settings.value(kStep, 0).toInt(), 0, int(PrepareStep::archive)));
  recording_to_restore_ = settings.value(kRecording).toString();
  target_to_restore_ = settings.value(kTarget).toString();
  cortex_.restoreLook();
  const bool has_case = !folder.isEmpty() && QFileInfo::exists(folder);
  if (has_case) {
    was_guiding_ = settings.value(kGuiding, false).toBool();
    step_to_restore_ = step;  // set when the case is open
    prepare_.openCase(folder);
  }
  setWorkspace(workspace);
}

/// Goes from case opened to recording opened to target chosen. No alignment is restored, since the head has
/// moved.
void MainWindow::goOnRestoring() {
  if (tasks_.isRunning() || !model_.isOpen()) return;
  const QString recording = std::exchange(recording_to_restore_, {});
  if (const QString target = std::exchange(target_to_restore_, {}); !target.isEmpty())
    for (const auto& t : model_.current().plan.targets)
      if (t.name == target.toStdString()) treat_.chooseTarget(target);
  if (!recording.isEmpty() && QFileInfo::exists(recording + "/stereo.yml") && !treat_.hasRecording())
    return treat_.openRecording(recording);
  if (std::exchange(was_guiding_, false))
    task_bar_->showNotice(
        tr("guidance was running when the window went: Treat offers to go on with that session"));
}

/// Saves the state; called at every change, because a crash gives no warning.
void MainWindow::remember() {
  if (!is_remembering_) return;
  QSettings settings;
  settings.setValue(kWorkspace, stack_->currentIndex());
  if (!step_to_restore_) settings.setValue(kStep, int(prepareStep()));
  settings.setValue(kGuiding, treat_.isRunning());
  if (target_to_restore_.isEmpty() && model_.isOpen()) settings.setValue(kTarget, treat_.targetName());
  if (recording_to_restore_.isEmpty() && (treat_.hasRecording() || model_.isOpen()))
    settings.setValue(kRecording, treat_.recordingFolder());
}

void MainWindow::showCaseWords() {
  if (!model_.isOpen()) {
    header_->setCaseWords({tr("no case open")});
    return;
  }
  const auto& c = model_.current();
  QString signed_off = signOffWords(c.sign_off);
  if (model_.override() && !c.sign_off.holds())
    signed_off += tr(" (override by %1)").arg(model_.override()->by);
  header_->setCaseWords({c.label.isEmpty() ? tr("case %1").arg(c.id) : tr("%1 (case %2)").arg(c.label, c.id),
                         signed_off, treat_.alignmentWords()});
}

void MainWindow::showLive(const ReadOut& read_out) {
  holdQueue();
  header_->setLive(read_out);
}

/// Asks without holding up the window: guidance goes on meanwhile.
void MainWindow::askBeforeClosing() {
  if (const auto* asked = findChild<QMessageBox*>("close_question"); asked && asked->isVisible()) return;
  auto* question =
      new QMessageBox(QMessageBox::Question, tr("FaceNav"), tr("A session is running. Close the window?"),
                      QMessageBox::NoButton, this);
  question->setObjectName("close_question");
  question->setAttribute(Qt::WA_DeleteOnClose);
  question->setInformativeText(tr("A session that is closed at once can be continued later."));
  auto* stay = question->addButton(tr("Keep the session"), QMessageBox::RejectRole);
  auto* end = question->addButton(tr("End the session\u2026"), QMessageBox::ActionRole);
  auto* close_now = question->addButton(tr("Close at once"), QMessageBox::DestructiveRole);
  question->setDefaultButton(qobject_cast<QPushButton*>(stay));
  question->setEscapeButton(stay);
  connect(end, &QAbstractButton::clicked, this, [this] {
    setWorkspace(Workspace::treat);
    treat_.askEnd();
  });
  connect(close_now, &QAbstractButton::clicked, this, [this] {
    is_closing_ = true;
    close();
  });
  question->open();
}

/// Shows the report of the session that was just ended.
void MainWindow::showEnded(const QString& session) {
  if (!model_.isOpen() || !std::filesystem::exists(review_.folderOf(session))) return;  // another case by now
  setWorkspace(Workspace::review);
  review_.choose(session);
  review_.refresh();
  review_workspace_->setPage(ReviewPage::report);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (treat_.isRunning() && !is_closing_) {
    event->ignore();
    return askBeforeClosing();
  }
  treat_.stop("the window was closed");
  remember();
  QSettings settings;
  settings.setValue(kGeometry, saveGeometry());
  event->accept();
}

}  // namespace facenav::ui
