#include "plan/import_window.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QShortcut>
#include <QVBoxLayout>
#include <utility>

#include "plan/import_choices.h"
#include "plan/import_list.h"
#include "plan/import_view.h"
#include "plan/other_words.h"
#include "shell/appearance.h"
#include "shell/help_window.h"
#include "shell/narrow_label.h"
#include "shell/scroll_column.h"
#include "shell/work_area.h"

namespace facenav::ui {
namespace {

constexpr QSize kImportSize{1240, 680};
constexpr int kDetail_px = 110, kChoices_px = 350;

}  // namespace

ImportWindow::ImportWindow(CaseModel& model, PlanPresenter& plan, QWidget* parent)
    : QWidget(parent, Qt::Window), presenter_(model, plan) {
  setWindowTitle(tr("FaceNav: targets from another navigator"));
  setAttribute(Qt::WA_DeleteOnClose);
  setAutoFillBackground(true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 10, 12, 10);
  auto* row = new QHBoxLayout;
  row->addWidget(makeLeft(), 3);
  row->addWidget(makeRight(model), 2);
  column->addLayout(row, 1);
  fault_ = new QLabel(this);
  fault_->setObjectName("fault");
  makeNarrow(*fault_);
  fault_->hide();
  column->addWidget(fault_);
  column->addLayout(makeButtons());
  auto* leave = new QShortcut(Qt::Key_Escape, this);
  leave->setWhatsThis(tr("close; nothing comes in"));
  connect(leave, &QShortcut::activated, this, &QWidget::close);
  HelpWindow::addKey(*this, "interop.md", "in-the-window");
  connect(list_, &ImportList::chosenChanged, this, &ImportWindow::showChosen);
  connect(view_, &ImportView::picked, list_, &ImportList::choose);
  connect(&presenter_, &ImportPresenter::changed, this, &ImportWindow::showRead);
  connect(&presenter_, &ImportPresenter::refused, this, [this](const QString& words) {
    if (!was_shown_) return void((emit refused(words), close()));
    fault_->setText(words);
    fault_->show();
  });
  connect(&presenter_, &ImportPresenter::broughtIn, this, &ImportWindow::broughtIn);
  connect(&presenter_, &ImportPresenter::broughtIn, this, &QWidget::close);
  connect(&model, &CaseModel::opened, this, &QWidget::close);  // the files were judged by another head
  fitIntoWorkArea(*this, kImportSize);
}

QWidget* ImportWindow::makeLeft() {
  auto* panel = new QWidget(this);
  auto* column = new QVBoxLayout(panel);
  column->setContentsMargins(0, 0, 0, 0);
  summary_ = new QLabel(panel);
  summary_->setObjectName("heading");
  makeNarrow(*summary_);
  list_ = new ImportList(presenter_, panel);
  detail_ = new QLabel(panel);
  detail_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  detail_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  makeNarrow(*detail_);
  auto* scrolled = new ScrollColumn(detail_, 0, panel);
  whenTextScales(this, [scrolled] { scrolled->setFixedHeight(sized(kDetail_px)); });
  column->addWidget(summary_);
  column->addWidget(list_, 1);
  column->addWidget(scrolled);
  return panel;
}

QWidget* ImportWindow::makeRight(CaseModel& model) {
  auto* panel = new QWidget(this);
  auto* column = new QVBoxLayout(panel);
  column->setContentsMargins(0, 0, 0, 0);
  view_ = new ImportView(presenter_, model, panel);
  choices_ = new ImportChoices(presenter_, panel);
  column->addWidget(view_, 1);
  column->addWidget(new ScrollColumn(choices_, kChoices_px, panel));
  return panel;
}

QHBoxLayout* ImportWindow::makeButtons() {
  auto* row = new QHBoxLayout;
  all_ = new QPushButton(tr("Tick &all"), this);
  none_ = new QPushButton(tr("Tick &none"), this);
  auto* cancel = new QPushButton(tr("Cancel"), this);
  cancel->setToolTip(tr("nothing comes in (Esc)"));
  bring_in_ = new QPushButton(tr("&Bring in"), this);
  bring_in_->setObjectName("primary");
  bring_in_->setToolTip(tr("writes what is ticked into the case; one step to undo (Ctrl+Return)"));
  bring_in_->setShortcut(Qt::CTRL + Qt::Key_Return);
  row->addWidget(all_);
  row->addWidget(none_);
  row->addStretch(1);
  row->addWidget(cancel);
  row->addWidget(bring_in_);
  connect(all_, &QPushButton::clicked, this, [this] { presenter_.takeAll(true); });
  connect(none_, &QPushButton::clicked, this, [this] { presenter_.takeAll(false); });
  connect(cancel, &QPushButton::clicked, this, &QWidget::close);
  connect(bring_in_, &QPushButton::clicked, &presenter_, &ImportPresenter::bringIn);
  return row;
}

void ImportWindow::open(const QStringList& files) {
  presenter_.open(files);
  showState();
}

/// Shows the window with the first answer, or closes it if there is nothing to show.
void ImportWindow::showRead() {
  const auto& files = presenter_.files();
  if (!was_shown_ && files.size() == 1 && !files.front().failure.empty()) {
    emit refused(inWindowWords(files.front().failure));
    return void(close());
  }
  fault_->hide();
  showState();
  if (std::exchange(was_shown_, true)) return;
  show();
  raise();
  activateWindow();
  list_->setFocus();
}

void ImportWindow::showState() {
  summary_->setText(presenter_.summary());
  const bool comes_something = presenter_.targets() + presenter_.pulses() > 0;
  bring_in_->setEnabled(comes_something && !presenter_.isReading());
}

void ImportWindow::showChosen() {
  const ImportRow row = list_->chosen();
  detail_->setText(list_->describe());
  choices_->showFile(row.file);
  view_->setChosen(row);
}

}  // namespace facenav::ui
