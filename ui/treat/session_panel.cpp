#include "treat/session_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSlider>
#include <QVBoxLayout>

#include "shell/appearance.h"
#include "shell/shown_words.h"
#include "treat/offer_panel.h"
#include "treat/outputs_row.h"
#include "treat/screens_row.h"
#include "treat/second_coil_row.h"

namespace facenav::ui {
namespace {

namespace events = report::session_events;

/// Reasons that are offered for a pause.
constexpr const char* kPauseReasons[] = {QT_TRANSLATE_NOOP("facenav::ui::SessionPanel", "patient asked"),
                                         QT_TRANSLATE_NOOP("facenav::ui::SessionPanel", "coil too warm"),
                                         QT_TRANSLATE_NOOP("facenav::ui::SessionPanel", "position lost"),
                                         QT_TRANSLATE_NOOP("facenav::ui::SessionPanel", "equipment")};

QHBoxLayout* rowIn(QWidget* widget) {
  auto* row = new QHBoxLayout(widget);
  row->setContentsMargins(0, 0, 0, 0);
  return row;
}

}  // namespace

SessionPanel::SessionPanel(TreatPresenter& treat, SessionSounds& sounds, SecondScreens& screens,
                           ProjectorPresenter& projector, QWidget* parent)
    : QFrame(parent), treat_(treat), sounds_(sounds) {
  setObjectName("panel");
  auto* column = new QVBoxLayout(this);
  column->addWidget(new OfferPanel(treat.offers(), OfferPanel::Page::treat, this));
  for (QWidget* each : {makePause(), makePain(), makeAdverse(), makeSource(), makeSound()})
    column->addWidget(each);
  column->addWidget(new SecondCoilRow(treat, this));
  column->addWidget(new OutputsRow(treat, this));
  column->addWidget(new ScreensRow(screens, projector, this));
  column->addStretch(1);
  connect(&treat_, &TreatPresenter::changed, this, &SessionPanel::showState);
  showState();
}

QWidget* SessionPanel::makePause() {
  auto* bar = new QWidget(this);
  auto* row = rowIn(bar);
  pause_ = new QPushButton(bar);
  pause_->setToolTip(tr("a pause or its end, with the time, in the session's log"));
  reason_ = new QComboBox(bar);
  reason_->setAccessibleName(tr("reason of the pause"));
  reason_->setEditable(true);
  for (const char* reason : kPauseReasons) reason_->addItem(tr(reason));
  reason_->setToolTip(tr("why the treatment is paused"));
  row->addWidget(pause_);
  row->addWidget(reason_, 1);
  connect(pause_, &QPushButton::clicked, this,
          [this] { treat_.isPaused() ? treat_.resume() : treat_.pause(pauseReason()); });
  return bar;
}

/// The reason as the session's log keeps it: an offered one in English, else what was typed.
QString SessionPanel::pauseReason() const {
  const int offered = reason_->findText(reason_->currentText());
  return offered < 0 ? reason_->currentText() : QString(kPauseReasons[offered]);
}

/// Makes the pain choice. A choice is logged at once; a correction is a second entry, and the report shows
/// both.
QWidget* SessionPanel::makePain() {
  auto* bar = new QWidget(this);
  auto* row = rowIn(bar);
  const auto addBox = [&](const QString& name, const char* event) {
    auto* box = new QComboBox(bar);
    box->addItem(QStringLiteral("\u2013"));
    for (int pain = 0; pain <= 10; ++pain) box->addItem(QString::number(pain));
    box->setToolTip(tr("0: none, 10: the worst imaginable; kept in the session's log"));
    box->setAccessibleName(name);
    row->addWidget(new QLabel(name, bar));
    row->addWidget(box);
    connect(box, QOverload<int>::of(&QComboBox::activated), this, [this, box, event](int index) {
      if (index > 0 && !treat_.note(event, box->currentText())) box->setCurrentIndex(0);
    });
  };
  addBox(tr("pain before"), events::kPainBefore);
  addBox(tr("after"), events::kPainAfter);
  row->addStretch(1);
  return bar;
}

QWidget* SessionPanel::makeAdverse() {
  auto* bar = new QWidget(this);
  auto* row = rowIn(bar);
  auto* words = new QLineEdit(bar);
  words->setAccessibleName(tr("adverse event"));
  words->setPlaceholderText(tr("adverse event"));
  words->setToolTip(tr("what happened, in words; kept in the session's log and report"));
  auto* note = new QPushButton(tr("Note"), bar);
  note->setToolTip(tr("keeps it with the time (Enter)"));
  row->addWidget(words, 1);
  row->addWidget(note);
  const auto keep = [this, words] {
    if (treat_.note(events::kAdverse, words->text())) words->clear();
  };
  connect(note, &QPushButton::clicked, this, keep);
  connect(words, &QLineEdit::returnPressed, this, keep);
  return bar;
}

QWidget* SessionPanel::makeSource() {
  auto* bar = new QWidget(this);
  auto* row = rowIn(bar);
  source_ = new QLineEdit(bar);
  source_->setAccessibleName(tr("pulses from"));
  source_->setPlaceholderText(tr("pulses: keyboard alone"));
  source_->setToolTip(tr("where pulses come from beside the key P: %1. It only listens; nothing is fired.")
                          .arg(shownWords(links::pulseSourceWords())));
  row->addWidget(new QLabel(tr("pulses from"), bar));
  row->addWidget(source_, 1);
  connect(source_, &QLineEdit::editingFinished, this, [this] {
    if (source_->text().trimmed() != treat_.pulseSource()) treat_.setPulseSource(source_->text());
    source_->setText(treat_.pulseSource());
  });
  return bar;
}

QWidget* SessionPanel::makeSound() {
  auto* bar = new QWidget(this);
  auto* row = rowIn(bar);
  sound_ = new QCheckBox(tr("sound"), bar);
  sound_->setChecked(!sounds_.isMuted());
  sound_->setToolTip(tr("falling: lost; one tone: near the target; rising: on target; click: a pulse"));
  auto* volume = new QSlider(Qt::Horizontal, bar);
  volume->setAccessibleName(tr("volume of the tones"));
  volume->setRange(0, 100);
  volume->setValue(int(100 * sounds_.volume()));
  volume->setToolTip(tr("volume of the tones"));
  row->addWidget(sound_);
  row->addWidget(volume, 1);
  connect(sound_, &QCheckBox::toggled, this, [this](bool is_on) { sounds_.setMuted(!is_on); });
  connect(volume, &QSlider::valueChanged, this, [this](int percent) { sounds_.setVolume(percent / 100.0); });
  return bar;
}

void SessionPanel::showState() {
  pause_->setText(treat_.isPaused() ? tr("Go on") : tr("Pause"));
  pause_->setEnabled(treat_.isRunning());
  reason_->setEnabled(!treat_.isPaused());
  if (!sounds_.failure().empty()) sound_->setText(tr("no sound on this machine"));
  if (!source_->hasFocus()) source_->setText(treat_.pulseSource());
}

}  // namespace facenav::ui
