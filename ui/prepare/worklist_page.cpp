#include "prepare/worklist_page.h"

#include <QCheckBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QShortcut>
#include <QTableView>
#include <QVBoxLayout>

#include "prepare/worklist_delegate.h"
#include "shell/appearance.h"
#include "shell/elided_label.h"
#include "shell/users_words.h"
#include "shell/words_of_button.h"

namespace facenav::ui {

WorklistPage::WorklistPage(WorklistPresenter& presenter, PrepareQueue& queue, QWidget* parent)
    : QWidget(parent),
      presenter_(presenter),
      queue_(queue),
      table_(new WorklistTable(presenter, this)),
      filter_(new WorklistFilter(*table_, this)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(makeHead());
  makeTable();
  addKeys();
  column->addWidget(view_, 1);
  empty_ = new QLabel(this);
  empty_->setObjectName("muted");
  empty_->setAlignment(Qt::AlignCenter);
  empty_->setWordWrap(true);
  column->addWidget(empty_);
  column->addWidget(makeActions());
  connect(&presenter_, &WorklistPresenter::changed, this, &WorklistPage::showState);
  connect(view_->selectionModel(), &QItemSelectionModel::currentChanged, this, &WorklistPage::showState);
  const auto chooseOne = [this] {
    if (!view_->currentIndex().isValid() && filter_->rowCount() > 0) view_->selectRow(0);
  };
  connect(filter_, &QAbstractItemModel::modelReset, this, chooseOne);
  connect(filter_, &QAbstractItemModel::rowsInserted, this, chooseOne);
  showState();
}

QWidget* WorklistPage::makeHead() {
  auto* head = new QWidget(this);
  auto* row = new QHBoxLayout(head);
  row->setContentsMargins(0, 0, 0, 0);
  search_ = new QLineEdit(head);
  search_->setAccessibleName(tr("filter of the worklist"));
  search_->setPlaceholderText(tr("Type to filter: state, case, name, finding"));
  search_->setToolTip(tr("every word must occur somewhere in the line (just type; Esc clears)"));
  search_->setClearButtonEnabled(true);
  search_->installEventFilter(this);
  folder_ = new ElidedLabel(head);
  markUsersWords(*folder_);
  folder_->setObjectName("muted");
  auto* change = new QPushButton(tr("Cases folder\u2026"), head);
  change->setToolTip(tr("where cases are kept and made (remembered)"));
  row->addWidget(search_, 2);
  row->addSpacing(12);
  row->addWidget(folder_, 1);
  row->addWidget(change);
  connect(search_, &QLineEdit::textChanged, filter_, &WorklistFilter::setWords);
  connect(change, &QPushButton::clicked, this, &WorklistPage::chooseFolder);
  return head;
}

void WorklistPage::makeTable() {
  view_ = new QTableView(this);
  view_->setModel(filter_);
  view_->setItemDelegate(new WorklistDelegate(view_));
  view_->setSelectionBehavior(QAbstractItemView::SelectRows);
  view_->setSelectionMode(QAbstractItemView::SingleSelection);
  view_->setEditTriggers(QAbstractItemView::EditKeyPressed);  // F2 edits the name; letters go to the filter
  view_->setSortingEnabled(true);
  view_->sortByColumn(WorklistTable::age, Qt::AscendingOrder);
  view_->setShowGrid(false);
  view_->setAlternatingRowColors(true);
  view_->setTabKeyNavigation(false);
  view_->setAccessibleName(tr("worklist"));
  view_->verticalHeader()->hide();
  whenTextScales(this, [this] { view_->verticalHeader()->setDefaultSectionSize(sized(36)); });
  view_->horizontalHeader()->setStretchLastSection(true);
  view_->horizontalHeader()->setHighlightSections(false);
  whenTextScales(this, [this] {
    const int widths[] = {130, 220, 90, 90, 140};
    for (int i = 0; i < 5; ++i) view_->setColumnWidth(i, sized(widths[i]));
  });
  view_->installEventFilter(this);
  view_->setContextMenuPolicy(Qt::CustomContextMenu);
  connect(view_, &QTableView::doubleClicked, this, &WorklistPage::openChosen);
  connect(view_, &QTableView::customContextMenuRequested, this, &WorklistPage::showMenu);
}

/// Adds the keys of the table itself; a label being typed keeps its own.
void WorklistPage::addKeys() {
  const auto key = [this](int code, const QString& words, auto action) {
    auto* shortcut = new QShortcut(code, view_);
    shortcut->setContext(Qt::WidgetShortcut);
    shortcut->setWhatsThis(words);
    connect(shortcut, &QShortcut::activated, this, action);
  };
  for (const int enter : {Qt::Key_Return, Qt::Key_Enter})
    key(enter, tr("open the chosen line of the worklist"), [this] { openChosen(); });
  key(Qt::Key_F2, tr("label the chosen case"), [this] {
    if (const auto* row = chosen(); row && row->can_be_labelled) labelChosen();
  });
  key(Qt::Key_F5, tr("put the chosen line back into the queue"), [this] {
    if (const auto* row = chosen(); row && row->job_id) queue_.retry(row->job_id);
  });
  key(Qt::Key_Delete, tr("delete the chosen case, after a question; take a line off the list"),
      [this] { removeChosen(); });
}

QWidget* WorklistPage::makeActions() {
  auto* box = new QWidget(this);
  auto* rows = new QVBoxLayout(box);
  rows->setContentsMargins(0, 0, 0, 0);
  auto* row = new QHBoxLayout;
  const auto button = [&](const QString& text, const QString& tip, auto action) {
    auto* made = new QPushButton(text, box);
    made->setToolTip(tip);
    connect(made, &QPushButton::clicked, this, action);
    return made;
  };
  open_ =
      button(tr("Open"), tr("open the case to check it (Return, double click)"), [this] { openChosen(); });
  open_->setObjectName("primary");
  whenTextScales(this, [this] {  // wide enough for both of its words
    open_->ensurePolished();
    open_->setMinimumWidth(open_->fontMetrics().horizontalAdvance(tr("Show series")) + sized(36));
  });
  label_ = button(tr("Label\u2026"), tr("what you call the case here; kept with it, private to you (F2)"),
                  [this] { labelChosen(); });
  cancel_ = button(tr("Cancel"), tr("stop preparing; nothing half-done is kept (Del)"), [this] {
    if (const auto* row_ = chosen()) queue_.cancel(row_->job_id);
  });
  retry_ = button(tr("Try again"), tr("put the line back into the queue (F5)"), [this] {
    if (const auto* row_ = chosen()) queue_.retry(row_->job_id);
  });
  remove_ = button(tr("Take off the list"), tr("forget this input; no file is touched (Del)"), [this] {
    if (const auto* row_ = chosen()) queue_.remove(row_->job_id);
  });
  summary_ = new ElidedLabel(box);
  summary_->setObjectName("muted");
  for (auto* each : {open_, label_, cancel_, retry_, remove_}) row->addWidget(each);
  row->addStretch(1);
  auto* below = new QHBoxLayout;
  auto* by_patient = new QCheckBox(tr("label new cases with the patient's name"), box);
  by_patient->setToolTip(tr("from the DICOM files; a case holds no name unless this is on (remembered)"));
  by_patient->setChecked(queue_.labelsByPatient());
  connect(by_patient, &QCheckBox::toggled, &queue_, &PrepareQueue::setLabelsByPatient);
  below->addWidget(by_patient);
  below->addSpacing(12);
  below->addWidget(summary_, 1);
  rows->addLayout(row);
  rows->addLayout(below);
  return box;
}

const WorklistRow* WorklistPage::chosen() const {
  const auto index = view_->currentIndex();
  return index.isValid() ? &filter_->row(index) : nullptr;
}

void WorklistPage::openChosen() {
  const auto* row = chosen();
  if (!row) return;
  if (row->job_id == 0) {
    emit caseChosen(row->case_folder);
  } else if (const auto* job = queue_.job(row->job_id)) {
    emit inputChosen(job->input);
  }
}

void WorklistPage::labelChosen() {
  const auto index = view_->currentIndex();
  if (!index.isValid()) return;
  const auto name = index.siblingAtColumn(WorklistTable::name);
  view_->setFocus();
  view_->setCurrentIndex(name);
  view_->edit(name);
}

QString WorklistPage::removeWords() const {
  const auto* row = chosen();
  return row ? row->name : QString();
}

void WorklistPage::removeChosen() {
  const auto* row = chosen();
  if (!row) return;
  const auto* job = row->job_id ? queue_.job(row->job_id) : nullptr;
  if (!job) return askToDelete(*row);
  const bool is_pending = job->state == JobState::queued || job->state == JobState::preparing;
  is_pending ? queue_.cancel(row->job_id) : queue_.remove(row->job_id);
}

/// Asks, without holding up the window, before a case goes to the trash.
void WorklistPage::askToDelete(const WorklistRow& row) {
  auto* question = new QMessageBox(QMessageBox::Question, tr("FaceNav"), tr("Delete case %1?").arg(row.name),
                                   QMessageBox::NoButton, this);
  question->setObjectName("delete_question");
  question->setAttribute(Qt::WA_DeleteOnClose);
  question->setTextFormat(Qt::PlainText);
  question->setInformativeText(tr("Its model, targets and sessions go to the trash of this computer and can "
                                  "be restored from there.\n%1")
                                   .arg(row.case_folder));
  auto* keep = question->addButton(tr("Keep it"), QMessageBox::RejectRole);
  auto* remove = question->addButton(tr("Move to the trash"), QMessageBox::DestructiveRole);
  question->setDefaultButton(keep);
  question->setEscapeButton(keep);
  connect(remove, &QAbstractButton::clicked, this,
          [this, folder = row.case_folder] { presenter_.moveToTrash(folder); });
  question->open();
}

/// Shows what can be done with the chosen line. The keys stand beside it; the table owns them.
void WorklistPage::showMenu(const QPoint& at) {
  const auto* row = chosen();
  if (!row) return;
  auto* menu = new QMenu(this);
  menu->setObjectName("worklist_menu");
  menu->setAttribute(Qt::WA_DeleteOnClose);
  const auto add = [&](const QString& words, const char* keys, auto action) {
    menu->addAction(*keys ? words + "\t" + QKeySequence(keys).toString(QKeySequence::NativeText) : words,
                    this, action);
  };
  const bool is_case = row->job_id == 0;
  add(open_->text(), "Return", [this] { openChosen(); });
  if (row->can_be_labelled) {
    add(tr("Sign off, or reject the scan\u2026"), "",
        [this, folder = row->case_folder] { emit signOffWanted(folder); });
    add(label_->text(), "F2", [this] { labelChosen(); });
  }
  for (auto* button : {cancel_, retry_, remove_})
    if (button->isEnabled())
      add(button->text(), button == retry_ ? "F5" : "Del", [button] { button->click(); });
  menu->addSeparator();
  if (is_case) add(tr("Delete\u2026"), "Del", [this] { removeChosen(); });
  menu->popup(view_->viewport()->mapToGlobal(at));
}

void WorklistPage::showState() {
  const auto* row = chosen();
  const auto* job = row && row->job_id ? queue_.job(row->job_id) : nullptr;
  const bool is_pending = job && (job->state == JobState::queued || job->state == JobState::preparing);
  open_->setEnabled(row != nullptr);
  setWords(*open_, job ? tr("Show series") : tr("Open"));
  // What does not apply is grey, not gone: no button takes the place of another under the mouse.
  label_->setEnabled(row && row->can_be_labelled);
  cancel_->setEnabled(is_pending);
  retry_->setEnabled(job && !is_pending);
  remove_->setEnabled(job && !is_pending);
  folder_->set(presenter_.folder());
  const int cases = int(presenter_.rows().size()) - int(queue_.jobs().size());
  summary_->set(QStringList{tr("cases: %1").arg(cases), queue_.summary()}.join(
      queue_.summary().isEmpty() ? "" : "   "));
  empty_->setText(!presenter_.problem().isEmpty()
                      ? presenter_.problem()
                      : tr("Drop a DICOM folder or a NIfTI file anywhere in the window: "
                           "it is queued and prepared here."));
  empty_->setVisible(presenter_.rows().empty() || !presenter_.problem().isEmpty());
}

void WorklistPage::chooseFolder() {
  const QString folder = QFileDialog::getExistingDirectory(this, tr("Cases folder"), presenter_.folder());
  if (!folder.isEmpty()) presenter_.setFolder(folder);
}

/// Letters typed over the table go to the filter; arrows and Return typed in the filter go to the table.
bool WorklistPage::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::KeyPress) return QWidget::eventFilter(watched, event);
  auto* key = static_cast<QKeyEvent*>(event);
  if (watched == search_) {
    if (key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter) return openChosen(), true;
    if (key->key() == Qt::Key_Escape) return search_->clear(), true;
    if (key->key() != Qt::Key_Down) return false;
    view_->setFocus();
    return true;
  }
  if (key->text().isEmpty() || !key->text().front().isPrint() || key->modifiers() & Qt::ControlModifier)
    return false;
  search_->setFocus();
  search_->insert(key->text());
  return true;
}

}  // namespace facenav::ui
