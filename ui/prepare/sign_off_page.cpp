#include "prepare/sign_off_page.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStyle>
#include <QVBoxLayout>
#include <QVariant>

#include "prepare/montage_view.h"
#include "shell/appearance.h"
#include "shell/author.h"
#include "shell/wrapped_list.h"

namespace facenav::ui {
namespace {

constexpr int kMissingLines = 3;

QLabel* wrapped(QWidget* parent, const char* name) {
  auto* label = new QLabel(parent);
  label->setObjectName(name);
  label->setWordWrap(true);
  return label;
}

}  // namespace

SignOffPage::SignOffPage(SignOffPresenter& presenter, CaseModel& model, QWidget* parent)
    : QWidget(parent), presenter_(presenter), model_(model), montage_(new MontageView(this)) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(montage_, 1);
  row->addWidget(makePanel());
  connect(montage_, &MontageView::chosen, this, &SignOffPage::lookCloser);
  connect(&presenter_, &SignOffPresenter::changed, this, &SignOffPage::showState);
  const auto beginAnew = [this] {
    is_outdated_ = true;
    if (name_->text().isEmpty()) name_->setText(author());
    fillItems();
    if (isVisible()) showEvent(nullptr);
  };
  connect(&model_, &CaseModel::opened, this, beginAnew);
  connect(&model_, &CaseModel::brainChanged, this, beginAnew);
  connect(&model_, &CaseModel::draftChanged, this, beginAnew);
  showState();
}

QWidget* SignOffPage::makePanel() {
  auto* panel = new QFrame(this);
  panel->setObjectName("panel");
  whenTextScales(panel, [panel] { panel->setFixedWidth(sized(380)); });
  auto* column = new QVBoxLayout(panel);
  status_ = wrapped(panel, "verdict");
  volumes_ = wrapped(panel, "plain");
  auto* heading = new QLabel(tr("Seen, each by itself"), panel);
  heading->setObjectName("heading");
  items_ = new WrappedList(panel);
  items_->setToolTip(tr("tick each when you have looked at it (arrows, Space)"));
  items_->setAccessibleName(tr("what must be seen"));
  name_ = new QLineEdit(presenter_.name(), panel);
  name_->setAccessibleName(tr("your name or initials"));
  name_->setPlaceholderText(tr("your name or initials"));
  name_->setToolTip(tr("kept with the case and remembered here; never the patient's name"));
  note_ = new QLineEdit(panel);
  note_->setAccessibleName(tr("note of the sign-off"));
  note_->setToolTip(tr("kept with the sign-off; no patient's name"));
  sign_ = new QPushButton(tr("Sign off"), panel);
  sign_->setObjectName("primary");
  sign_->setToolTip(tr("the case may then be treated (Ctrl+Return)"));
  sign_->setShortcut(Qt::CTRL + Qt::Key_Return);
  reject_ = new QPushButton(tr("Reject: ask for a new scan"), panel);
  reject_->setToolTip(tr("needs your name and a reason; the worklist shows them, and the scan is not used"));
  missing_ = wrapped(panel, "muted");
  missing_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  whenTextScales(this, [this] {  // fields stay in place
    missing_->ensurePolished();
    missing_->setMinimumHeight(kMissingLines * missing_->fontMetrics().lineSpacing());
  });
  column->addWidget(status_);
  column->addWidget(volumes_);
  column->addWidget(heading);
  column->addWidget(items_, 1);
  for (QWidget* each :
       {static_cast<QWidget*>(name_), static_cast<QWidget*>(note_), static_cast<QWidget*>(missing_),
        static_cast<QWidget*>(sign_), static_cast<QWidget*>(reject_)})
    column->addWidget(each);
  connect(items_, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) {
    if (!is_filling_) presenter_.setSeen(items_->row(item), item->checkState() == Qt::Checked);
  });
  connect(name_, &QLineEdit::textChanged, &presenter_, &SignOffPresenter::setName);
  connect(note_, &QLineEdit::textChanged, &presenter_, &SignOffPresenter::setNote);
  connect(sign_, &QPushButton::clicked, &presenter_, &SignOffPresenter::sign);
  connect(reject_, &QPushButton::clicked, &presenter_, &SignOffPresenter::reject);
  return panel;
}

void SignOffPage::fillItems() {
  is_filling_ = true;
  items_->clear();
  for (const QString& words : presenter_.items()) {
    auto* item = new QListWidgetItem(words, items_);
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
    item->setCheckState(Qt::Unchecked);
  }
  note_->clear();
  is_filling_ = false;
  showTicks();
}

/// Ticks every item if a sign-off is valid.
void SignOffPage::showTicks() {
  if (!presenter_.holds()) return;
  is_filling_ = true;
  for (int i = 0; i < items_->count(); ++i) items_->item(i)->setCheckState(Qt::Checked);
  is_filling_ = false;
}

void SignOffPage::showState() {
  const char* level = presenter_.holds() ? "good" : presenter_.isVoid() ? "caution" : "lost";
  const QString mark = presenter_.holds() ? tr("\u2713  ") : presenter_.isVoid() ? tr("!  ") : tr("\u25cb  ");
  status_->setText(model_.isOpen() ? mark + presenter_.statusWords() : tr("no case open"));
  status_->setProperty("level", level);
  status_->style()->unpolish(status_);
  status_->style()->polish(status_);
  QStringList words;
  for (const auto& line : presenter_.volumes())
    words << (line.is_normal ? tr("\u2713  ") : tr("!  ")) + line.words;
  volumes_->setText(words.join('\n'));
  showTicks();
  items_->setEnabled(!presenter_.holds());
  // A disabled button would hand the focus to Reject, which the next Space would press.
  if (!presenter_.canSign()) sign_->clearFocus();
  sign_->setEnabled(presenter_.canSign());
  reject_->setEnabled(presenter_.canReject());
  note_->setPlaceholderText(presenter_.isNotUsable() ? tr("reason (the scan is not usable)")
                                                     : tr("note; the reason if you reject the scan"));
  const bool is_rejected = model_.isOpen() && model_.current().sign_off.rejection;
  const QString asks = presenter_.whatToAskFor();
  missing_->setText(presenter_.holds()               ? QString()
                    : is_rejected && !asks.isEmpty() ? tr("ask for: %1").arg(asks)
                                                     : presenter_.whatIsMissing());
}

void SignOffPage::showEvent(QShowEvent*) {
  if (!model_.isOpen() || (!is_outdated_ && !model_.current().draft)) return;
  is_outdated_ = false;  // a draft may have changed since
  montage_->show(model_.current());
  showState();
}

}  // namespace facenav::ui
