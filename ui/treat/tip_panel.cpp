#include "treat/tip_panel.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "shell/narrow_label.h"

namespace facenav::ui {

TipPanel::TipPanel(TipPresenter& tip, TreatPresenter& treat, QWidget* parent)
    : QFrame(parent), tip_(tip), treat_(treat) {
  setObjectName("panel");
  auto* column = new QVBoxLayout(this);
  skin_ = new QCheckBox(tr("MRI's skin over the pictures"), this);
  skin_->setToolTip(
      tr("the MRI's skin where the head's pose puts it: its outline must lie on the face's, in both pictures "
         "(O)"));
  skin_->setShortcut(Qt::Key_O);
  connect(skin_, &QCheckBox::toggled, &treat_, &TreatPresenter::showSkin);
  column->addWidget(makeFigures());
  column->addWidget(makeJudgement());  // before the words, so that figures and buttons stay visible in a low
                                       // window
  words_ = new QLabel(this);
  words_->setObjectName("tip_words");
  makeNarrow(*words_);
  column->addWidget(words_);
  column->addWidget(skin_);
  column->addStretch(1);
  connect(&tip_, &TipPresenter::changed, this, &TipPanel::showState);
  connect(&treat_, &TreatPresenter::changed, this, &TipPanel::showState);
  showState();
}

QWidget* TipPanel::makeFigures() {
  auto* figures = new QWidget(this);
  auto* grid = new QGridLayout(figures);
  grid->setContentsMargins(0, 0, 0, 0);
  const auto add = [&](int column, const QString& tip, QLabel*& value, QLabel*& words) {
    value = new QLabel(figures);
    value->setObjectName("figure");
    value->setAlignment(Qt::AlignCenter);
    value->setToolTip(tip);
    words = new QLabel(figures);
    words->setObjectName("muted");
    words->setAlignment(Qt::AlignHCenter | Qt::AlignTop);
    words->setWordWrap(true);
    words->setToolTip(tip);
    grid->addWidget(value, 0, column);
    grid->addWidget(words, 1, column);
    grid->setColumnStretch(column, 1);
  };
  add(0, tr("distance of the coil's tip, or of the clicked spot, from the MRI's skin"), off_skin_,
      skin_words_);
  add(1, tr("distance of the coil's tip, or of the clicked spot, from the named place that is nearest"),
      off_place_, place_words_);
  return figures;
}

QWidget* TipPanel::makeJudgement() {
  auto* bar = new QWidget(this);
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(0, 0, 0, 0);
  right_ = new QPushButton(tr("%1 Matches").arg(QChar(0x2713)), bar);
  right_->setToolTip(tr("tip or spot is where the figures say; kept in the session's log (R)"));
  right_->setShortcut(Qt::Key_R);
  wrong_ = new QPushButton(tr("%1 Does not match").arg(QChar(0x2715)), bar);
  wrong_->setToolTip(
      tr("tip or spot is elsewhere; kept in the session's log. Guidance is withheld until a measured "
         "check passes (W)"));
  wrong_->setShortcut(Qt::Key_W);
  row->addWidget(right_, 1);
  row->addWidget(wrong_, 1);
  connect(right_, &QPushButton::clicked, this, [this] { tip_.judge(steps::TipVerdict::right); });
  connect(wrong_, &QPushButton::clicked, this, [this] { tip_.judge(steps::TipVerdict::wrong); });
  return bar;
}

void TipPanel::showState() {
  const QSignalBlocker quiet(skin_);
  skin_->setChecked(treat_.showsSkin());
  off_skin_->setText(tip_.offSkin());
  off_place_->setText(tip_.offPlace());
  off_skin_->setEnabled(tip_.canJudge());
  off_place_->setEnabled(tip_.canJudge());
  skin_words_->setText(tip_.skinWords());
  place_words_->setText(tip_.placeWords());
  words_->setText(tip_.words());
  right_->setEnabled(tip_.canJudge());
  wrong_->setEnabled(tip_.canJudge());
}

}  // namespace facenav::ui
