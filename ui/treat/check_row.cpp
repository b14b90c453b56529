#include "treat/check_row.h"

#include <QHBoxLayout>
#include <QPushButton>
#include <QStyle>
#include <QVariant>

#include "shell/elided_label.h"

namespace facenav::ui {
namespace {

const char* nameOf(Level level) {
  return level == Level::good ? "good" : level == Level::idle ? "idle" : "bad";
}

QString markOf(Level level) {
  if (level == Level::good) return QString(QChar(0x2713)) + ' ';
  if (level == Level::idle) return {};
  return level == Level::lost ? QString(QChar(0x2715)) + ' ' : QStringLiteral("! ");
}

}  // namespace

CheckRow::CheckRow(CheckPresenter& check, TreatPresenter& treat, QWidget* parent)
    : QWidget(parent), check_(check), treat_(treat) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  words_ = new ElidedLabel(this);
  words_->setObjectName("check_words");
  button_ = new QPushButton(tr("Check"), this);
  button_->setToolTip(
      tr("measures for two seconds whether the MRI still lies on the face; the patient holds still (K)"));
  button_->setShortcut(Qt::Key_K);
  row->addWidget(words_, 1);
  row->addWidget(button_);
  connect(button_, &QPushButton::clicked, &check_, &CheckPresenter::begin);
  connect(&check_, &CheckPresenter::changed, this, &CheckRow::showState);
  connect(&treat_, &TreatPresenter::changed, this, &CheckRow::showState);
  QSizePolicy policy = sizePolicy();
  policy.setRetainSizeWhenHidden(true);  // what stands above stays where it is when guidance starts
  setSizePolicy(policy);
  showState();
}

void CheckRow::showState() {
  const QString words = check_.words();
  setVisible(!words.isEmpty());
  words_->set(markOf(check_.level()) + words);
  button_->setEnabled(treat_.isRunning() && !check_.isMeasuring());
  const QString level = nameOf(check_.level());
  if (words_->property("level").toString() == level) return;
  words_->setProperty("level", level);
  words_->style()->unpolish(words_);
  words_->style()->polish(words_);
}

}  // namespace facenav::ui
