#include "treat/pause_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QTime>

#include "shell/appearance.h"

namespace facenav::ui {
namespace {

constexpr double kSmall_pt = 13;  // of the line below the title

}  // namespace

PausePanel::PausePanel(TreatPresenter& treat, QWidget* parent) : QFrame(parent), treat_(treat) {
  setObjectName("pause_banner");
  auto* row = new QHBoxLayout(this);
  words_ = new QLabel(this);
  words_->setObjectName("pause_words");
  words_->setWordWrap(true);
  words_->setTextFormat(Qt::RichText);
  auto* go_on = new QPushButton(tr("Go on guiding"), this);
  go_on->setObjectName("primary");
  go_on->setToolTip(tr("ends the pause (Space)"));
  auto* end = new QPushButton(tr("End the session\u2026"), this);
  end->setToolTip(tr("asks for pain and adverse events, then closes the session and shows its report"));
  row->addWidget(words_, 1);
  row->addWidget(go_on);
  row->addWidget(end);
  connect(go_on, &QPushButton::clicked, &treat_, &TreatPresenter::guide);
  connect(end, &QPushButton::clicked, &treat_, &TreatPresenter::askEnd);
  connect(&treat_, &TreatPresenter::changed, this, &PausePanel::showState);
  showState();
}

void PausePanel::showState() {
  setVisible(treat_.isPaused() && !treat_.isEnding());
  refresh();
}

void PausePanel::refresh() {
  if (!isVisibleTo(parentWidget())) return;
  const QString length = QTime(0, 0).addMSecs(int(1e3 * treat_.pauseLength_s())).toString("h:mm:ss");
  const QString words =
      QStringLiteral("<div>%1  (%2)</div><div style='font-size:%3pt'>%4</div>")
          .arg(treat_.pauseWords().toHtmlEscaped(), length)
          .arg(kSmall_pt * textScale())
          .arg(tr("The clock holds. Pulses are kept and marked; nobody is guided.").toHtmlEscaped());
  if (words != words_->text()) words_->setText(words);
}

}  // namespace facenav::ui
