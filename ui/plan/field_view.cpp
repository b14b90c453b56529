#include "plan/field_view.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "shell/appearance.h"
#include "shell/colour_legend.h"
#include "shell/help_window.h"
#include "shell/narrow_label.h"

namespace facenav::ui {
namespace {

constexpr int kWordsLines = 4, kProposalLines = 2;  // that are always there: what is below stays in place

/// Gives a label the height of its lines, and more if its text needs more.
void fitHeight(QLabel& label, int lines) {
  label.setMinimumHeight(std::max(sized(kTextLine_px * lines),
                                  label.text().isEmpty() ? 0 : label.heightForWidth(label.width())));
}

}  // namespace

FieldView::FieldView(FieldPresenter& field, BestPosePresenter& best, QWidget* parent)
    : QFrame(parent), field_(field), best_(best) {
  HelpWindow::setPlace(*this, "field.md", "in-the-window");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  bar_ = new ColourLegend(this);
  bar_->setToolTip(
      tr("strength of the electric field on the brain; below a fifth of the maximum it is not coloured; the "
         "white lines are 50, 75 and 90 % of it; the slices show the same colours"));
  words_ = new QLabel(this);
  words_->setObjectName("figures_text");
  words_->setToolTip(tr("of the planned pose; what the numbers mean: the manual's page 'Field'"));
  makeNarrow(*words_);
  against_ = new QLabel(this);
  against_->setToolTip(tr(
      "what the pose of the target that you compare with would give: strength at the active target, place of "
      "the maximum, and the correlation of both fields on the cortex"));
  makeNarrow(*against_);
  aim_ = new QComboBox(this);
  aim_->addItems({tr("strongest"), tr("along normal")});
  aim_->setAccessibleName(tr("aim of the best pose"));
  aim_->setToolTip(
      tr("what the best pose gives most of: field at the target, or its part along the normal of "
         "the cortex there"));
  search_ = new QPushButton(tr("Best angle and place"), this);
  search_->setToolTip(tr("tries 36 angles at 25 places within 2 x 2 cm; the target stays until you take it"));
  take_ = new QPushButton(tr("Take it"), this);
  take_->setToolTip(tr("gives the target the pose that was found; Undo takes it back"));
  for (auto* button : {search_, take_}) button->setObjectName("tool");
  proposal_ = new QLabel(this);
  proposal_->setObjectName("muted");
  makeNarrow(*proposal_);
  auto* choice = new QHBoxLayout;
  choice->addWidget(aim_, 1);
  choice->addWidget(take_);
  column->addWidget(bar_);
  column->addWidget(words_);
  column->addWidget(against_);
  column->addWidget(search_);
  column->addLayout(choice);
  column->addWidget(proposal_);
  connect(aim_, QOverload<int>::of(&QComboBox::activated), this,
          [this](int item) { best_.setAim(steps::FieldAim(item)); });
  connect(search_, &QPushButton::clicked, &best_, &BestPosePresenter::search);
  connect(take_, &QPushButton::clicked, &best_, &BestPosePresenter::take);
  connect(&field_, &FieldPresenter::changed, this, &FieldView::showField);
  connect(&field_, &FieldPresenter::reachChanged, this, &FieldView::showAgainst);
  connect(&best_, &BestPosePresenter::changed, this, &FieldView::showBest);
  showField();
  showAgainst();
  showBest();
  whenTextScales(this, [this] { fitLabels(); });
}

void FieldView::fitLabels() {
  fitHeight(*words_, kWordsLines);
  fitHeight(*against_, 0);
  fitHeight(*proposal_, kProposalLines);
}

void FieldView::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  fitLabels();
}

void FieldView::showField() {
  setVisible(field_.isOn());
  words_->setText(field_.words());
  fitLabels();
  const auto* shown = field_.shown();
  if (!shown) return bar_->set(tr("no field"), tr("V/m"), 0, std::nullopt);
  const int decimals = shown->peak >= 10 ? 0 : shown->peak >= 1 ? 1 : 2;
  bar_->set(field_.barWords(), tr("V/m"), decimals, scene::fieldColours(shown->peak));
}

void FieldView::showAgainst() {
  against_->setText(field_.againstWords());
  against_->setVisible(!against_->text().isEmpty());
  fitLabels();
}

void FieldView::showBest() {
  aim_->setCurrentIndex(int(best_.aim()));
  search_->setEnabled(best_.isPossible());
  take_->setEnabled(best_.hasProposal());
  proposal_->setText(best_.words());
  fitLabels();
}

}  // namespace facenav::ui
