#include "treat/override_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include "shell/appearance.h"
#include "shell/author.h"

namespace facenav::ui {

OverridePanel::OverridePanel(TreatPresenter& presenter, CaseModel& model, QWidget* parent)
    : QFrame(parent), presenter_(presenter), model_(model) {
  setObjectName("warning");
  auto* row = new QHBoxLayout(this);
  words_ = new QLabel(this);
  words_->setWordWrap(true);
  name_ = new QLineEdit(this);
  reason_ = new QLineEdit(this);
  name_->setAccessibleName(tr("your name"));
  reason_->setAccessibleName(tr("reason"));
  name_->setPlaceholderText(tr("your name"));
  reason_->setPlaceholderText(tr("reason"));
  whenTextScales(this, [this] {
    name_->setMaximumWidth(sized(170));
    reason_->setMaximumWidth(sized(300));
  });
  name_->setToolTip(tr("who decides to treat; kept with the case"));
  reason_->setToolTip(tr("why it cannot wait for the sign-off; kept with the case"));
  override_ = new QPushButton(tr("Treat nevertheless"), this);
  override_->setToolTip(tr("recorded with name and reason in the case and in the session's log"));
  row->addWidget(words_, 1);
  for (QWidget* each :
       {static_cast<QWidget*>(name_), static_cast<QWidget*>(reason_), static_cast<QWidget*>(override_)})
    row->addWidget(each);
  const auto enable = [this] {
    override_->setEnabled(!name_->text().trimmed().isEmpty() && !reason_->text().trimmed().isEmpty());
  };
  connect(name_, &QLineEdit::textChanged, this, enable);
  connect(reason_, &QLineEdit::textChanged, this, enable);
  connect(reason_, &QLineEdit::returnPressed, override_, &QPushButton::click);
  connect(override_, &QPushButton::clicked, this, [this] {
    rememberAuthor(name_->text());
    presenter_.overrideSignOff(name_->text(), reason_->text());
  });
  connect(&model_, &CaseModel::opened, this, &OverridePanel::showState);
  connect(&model_, &CaseModel::signOffChanged, this, &OverridePanel::showState);
  enable();
  showState();
}

void OverridePanel::showState() {
  const bool is_open = model_.isOpen(), is_checked = is_open && model_.current().sign_off.holds();
  setVisible(is_open && !is_checked);
  if (!is_open || is_checked) return;
  const auto& given = model_.override();
  const QString words = signOffWords(model_.current().sign_off);
  const QString status = given ? words : words.left(1).toUpper() + words.mid(1);
  words_->setText(
      given ? tr("!  OVERRIDE (%1): treated on the decision of %2: %3").arg(status, given->by, given->reason)
            : tr("!  %1: this case is not offered for treatment. Have it checked "
                 "(Prepare, step 4), or give name and reason.")
                  .arg(status));
  for (QWidget* each :
       {static_cast<QWidget*>(name_), static_cast<QWidget*>(reason_), static_cast<QWidget*>(override_)})
    each->setVisible(!given);
  if (given) return;
  name_->setText(author());
  reason_->clear();
}

}  // namespace facenav::ui
