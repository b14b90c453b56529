#include "treat/end_panel.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace facenav::ui {

EndPanel::EndPanel(TreatPresenter& treat, QWidget* parent) : QFrame(parent), treat_(treat) {
  setObjectName("warning");
  words_ = new QLabel(this);
  words_->setObjectName("end_words");
  words_->setWordWrap(true);
  pain_ = new QComboBox(this);
  pain_->setObjectName("end_pain");
  pain_->addItem(tr("not asked"));
  for (int pain = 0; pain <= 10; ++pain) pain_->addItem(QString::number(pain));
  pain_->setToolTip(tr("0: none, 10: the worst imaginable; kept in the session's log and report"));
  pain_->setMinimumContentsLength(int(pain_->itemText(0).size()) + 1);
  pain_->setAccessibleName(tr("pain after"));
  adverse_ = new QLineEdit(this);
  adverse_->setAccessibleName(tr("adverse events"));
  adverse_->setObjectName("end_adverse");
  adverse_->setPlaceholderText(tr("adverse events, in words; empty: none"));
  adverse_->setToolTip(tr("kept in the session's log and report"));
  auto* end = new QPushButton(tr("End and show the report"), this);
  end->setObjectName("primary");
  end->setToolTip(tr("closes the session; it can still be read, and continued, later"));
  auto* back = new QPushButton(tr("Back to the session"), this);
  back->setToolTip(tr("the session goes on as it was (Space)"));
  auto* row = new QHBoxLayout;
  row->addWidget(new QLabel(tr("pain after"), this));
  row->addWidget(pain_);
  row->addStretch(1);
  auto* buttons = new QHBoxLayout;  // beside the list there is no room for doubled text
  buttons->addWidget(end);
  buttons->addWidget(back);
  buttons->addStretch(1);
  auto* column = new QVBoxLayout(this);
  column->addWidget(words_);
  column->addWidget(adverse_);
  column->addLayout(row);
  column->addLayout(buttons);
  connect(end, &QPushButton::clicked, this, &EndPanel::end);
  connect(adverse_, &QLineEdit::returnPressed, this, &EndPanel::end);
  connect(back, &QPushButton::clicked, &treat_, &TreatPresenter::cancelEnd);
  connect(&treat_, &TreatPresenter::changed, this, &EndPanel::showState);
  showState();
}

void EndPanel::showState() {
  const bool is_asked = treat_.isEnding();
  setVisible(is_asked);
  if (is_asked && !was_asked_) {
    words_->setText(tr("End of the session: %1.").arg(treat_.summary()));
    pain_->setCurrentIndex(0);
    adverse_->clear();
  }
  was_asked_ = is_asked;
}

void EndPanel::end() {
  const QString pain = pain_->currentIndex() > 0 ? pain_->currentText() : QString();
  treat_.end(pain, adverse_->text());
}

}  // namespace facenav::ui
