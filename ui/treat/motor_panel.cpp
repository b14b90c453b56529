#include "treat/motor_panel.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QShortcut>
#include <QVBoxLayout>
#include <tuple>
#include <vector>

#include "shell/appearance.h"
#include "shell/typed_number.h"
#include "shell/whole_choice.h"

namespace facenav::ui {
namespace {

QWidget* rowOf(QWidget* parent, const std::vector<QWidget*>& widgets, QWidget* stretched) {
  auto* widget = new QWidget(parent);
  auto* row = new QHBoxLayout(widget);
  row->setContentsMargins(0, 0, 0, 0);
  for (QWidget* each : widgets) row->addWidget(each, each == stretched ? 1 : 0);
  if (!stretched) row->addStretch(1);
  return widget;
}

}  // namespace

MotorPanel::MotorPanel(MotorPresenter& motor, TreatPresenter& treat, QWidget* parent)
    : QFrame(parent), motor_(motor), treat_(treat) {
  setObjectName("panel");
  auto* column = new QVBoxLayout(this);
  column->addWidget(makeAnswers());
  threshold_ = new QLabel(this);
  threshold_->setWordWrap(true);
  threshold_->setToolTip(tr("estimate and 95 % interval of the motor threshold, % of the maximal output"));
  column->addWidget(threshold_);
  dose_ = new QLabel(this);
  dose_->setObjectName("dose");
  dose_->setWordWrap(true);
  dose_->setToolTip(tr(
      "from the electric fields of hotspot and target, each at its planned pose; nothing is set by itself"));
  column->addWidget(dose_);
  column->addWidget(makeSearch());
  site_ = new QLabel(this);
  site_->setWordWrap(true);
  column->addWidget(site_);
  column->addWidget(makeHunt());
  column->addStretch(1);
  connect(&motor_, &MotorPresenter::changed, this, &MotorPanel::showState);
  showState();
}

QWidget* MotorPanel::makeAnswers() {
  auto* answers = new QWidget(this);
  auto* column = new QVBoxLayout(answers);
  column->setContentsMargins(0, 0, 0, 0);
  output_ = new QLineEdit(answers);
  whenTextScales(this, [this] { output_->setMaximumWidth(sized(70)); });
  output_->setToolTip(tr("output that the stimulator is set to, %; kept with each pulse"));
  output_->setAccessibleName(tr("output, %"));
  mep_ = new QLineEdit(answers);
  mep_->setAccessibleName(tr("MEP, uV"));
  whenTextScales(this, [this] { mep_->setMaximumWidth(sized(120)); });
  mep_->setToolTip(tr("peak-to-peak MEP of the pulse named below, uV; Enter keeps it"));
  mep_->setPlaceholderText(tr("MEP, uV"));
  question_ = new QLabel(answers);
  question_->setObjectName("motor_question");
  question_->setWordWrap(true);
  twitch_ = new QPushButton(tr("Yes, it moved"), answers);
  twitch_->setToolTip(tr("the muscle moved at the pulse named above (Y)"));
  none_ = new QPushButton(tr("No"), answers);
  none_->setToolTip(tr("the muscle did not move at the pulse named above (N)"));
  column->addWidget(rowOf(answers, {new QLabel(tr("output, %"), answers), output_, mep_}, nullptr));
  column->addWidget(question_);
  column->addWidget(rowOf(answers, {twitch_, none_}, nullptr));
  connect(output_, &QLineEdit::editingFinished, this, &MotorPanel::takeIntensity);
  connect(mep_, &QLineEdit::returnPressed, this, &MotorPanel::takeTyped);
  for (const auto& [button, key, has_response] :
       {std::tuple(twitch_, Qt::Key_Y, true), std::tuple(none_, Qt::Key_N, false)}) {
    const auto answer = [this, has_response = has_response] { motor_.answer(has_response); };
    auto* shortcut = new QShortcut(key, this);
    shortcut->setAutoRepeat(false);
    shortcut->setWhatsThis(button->toolTip().section(" (", 0, 0));
    connect(shortcut, &QShortcut::activated, this, answer);
    connect(button, &QPushButton::clicked, this, answer);
  }
  return answers;
}

QWidget* MotorPanel::makeSearch() {
  auto* bar = new QWidget(this);
  method_ = new WholeChoice(bar);
  method_->setAccessibleName(tr("method of the threshold"));
  method_->addItem(tr("Bayes, 20 pulses"), QVariant(int(stimulation::ThresholdMethod::bayes)));
  method_->addItem(tr("5 of 10"), QVariant(int(stimulation::ThresholdMethod::five_of_ten)));
  method_->setToolTip(tr("how the motor threshold is found"));
  muscle_ = new QLineEdit(bar);
  muscle_->setAccessibleName(tr("muscle"));
  muscle_->setPlaceholderText(tr("muscle"));
  muscle_->setToolTip(tr("muscle and side, as the report shall name it"));
  search_ = new QPushButton(bar);
  search_->setToolTip(tr("begins a search for the motor threshold, or goes on with an unfinished one"));
  back_ = new QPushButton(tr("Undo"), bar);
  back_->setToolTip(tr("takes the last answer back; its pulse can be answered again"));
  connect(search_, &QPushButton::clicked, this, [this] {
    if (motor_.isSearching()) return motor_.endSearch();
    motor_.search(stimulation::ThresholdMethod(method_->currentData().toInt()), muscle_->text());
  });
  connect(back_, &QPushButton::clicked, this, [this] { motor_.takeBack(); });
  auto* column = new QVBoxLayout(bar);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(rowOf(bar, {method_, muscle_}, muscle_));
  column->addWidget(rowOf(bar, {search_, back_}, nullptr));
  return bar;
}

QWidget* MotorPanel::makeHunt() {
  hunt_ = new QPushButton(this);
  previous_ = new QPushButton(tr("Back"), this);
  next_ = new QPushButton(tr("Next site"), this);
  hunt_->setToolTip(tr("a grid of 5 x 5 sites, 10 mm apart at the cortex, round the chosen target"));
  next_->setToolTip(tr("guide to the next site of the grid"));
  previous_->setToolTip(tr("guide to the site before"));
  connect(hunt_, &QPushButton::clicked, this,
          [this] { motor_.isHunting() ? motor_.endHunt() : motor_.hunt(); });
  connect(next_, &QPushButton::clicked, this, [this] { motor_.nextSite(); });
  connect(previous_, &QPushButton::clicked, this, [this] { motor_.nextSite(-1); });
  return rowOf(this, {hunt_, previous_, next_}, nullptr);
}

void MotorPanel::takeIntensity() {
  const auto typed = typedNumber(output_->text());
  const bool is_output = typed && *typed >= 0 && *typed <= 100;
  if (is_output && typed != treat_.intensity()) treat_.setIntensity(typed);
  if (output_->text().trimmed().isEmpty()) treat_.setIntensity(std::nullopt);
  showState();
}

void MotorPanel::takeTyped() {
  const auto mep_uv = typedNumber(mep_->text());
  if (!mep_uv) return;
  mep_->clear();
  motor_.answerWithMep(*mep_uv);
}

void MotorPanel::showQuestion() {
  const QString question = motor_.question();
  if (question != question_->text()) question_->setText(question);
  const bool can_answer = motor_.canAnswer();
  if (can_answer == twitch_->isEnabled()) return;
  for (QWidget* each : std::initializer_list<QWidget*>{twitch_, none_}) each->setEnabled(can_answer);
}

void MotorPanel::showState() {
  const auto intensity = treat_.intensity();
  if (!output_->hasFocus() || motor_.isSearching())
    output_->setText(intensity ? QString::number(*intensity, 'g', 4) : QString());
  showQuestion();
  threshold_->setText(motor_.thresholdWords());
  dose_->setText(motor_.doseWords());
  dose_->setVisible(!motor_.doseWords().isEmpty());
  search_->setText(motor_.isSearching() ? tr("End search") : tr("Find threshold"));
  back_->setEnabled(motor_.canTakeBack());
  method_->setEnabled(!motor_.isSearching());
  muscle_->setEnabled(!motor_.isSearching());
  hunt_->setText(motor_.isHunting() ? tr("End hunt") : tr("Hunt here"));
  hunt_->setEnabled(treat_.target() != nullptr);
  next_->setEnabled(motor_.isHunting());
  previous_->setEnabled(motor_.isHunting());
  site_->setText(motor_.siteWords());
  site_->setVisible(motor_.isHunting());
}

}  // namespace facenav::ui
