#include "treat/live_field_view.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QResizeEvent>

#include "shell/appearance.h"
#include "shell/colour_legend.h"
#include "shell/narrow_label.h"

namespace facenav::ui {
namespace {

constexpr int kBarWidth_px = 190, kLeastHeight_px = 56;

}  // namespace

LiveFieldView::LiveFieldView(LiveFieldPresenter& presenter, QWidget* parent)
    : QFrame(parent), presenter_(presenter), bar_(new ColourLegend(this)), words_(new QLabel(this)) {
  setObjectName("panel");
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(8, 2, 8, 2);
  bar_->setToolTip(
      tr("strength of the electric field on the brain; below a fifth of the maximum it is not coloured; the "
         "white lines are 50, 75 and 90 % of it"));
  words_->setObjectName("muted");
  words_->setToolTip(tr(
      "of the coil as it is held now, with its measured gap. In brackets: the range that the model's usual "
      "error, and the 95 % bound of the coil's pose, leave possible. What the numbers mean: the manual's "
      "page 'Field'"));
  makeNarrow(*words_);
  row->addWidget(bar_);
  row->addWidget(words_, 1);
  connect(&presenter_, &LiveFieldPresenter::changed, this, &LiveFieldView::showField);
  whenTextScales(this, [this] {
    bar_->setFixedWidth(sized(kBarWidth_px));
    setMinimumHeight(sized(kLeastHeight_px));
    fitHeight();
  });
  showField();
}

/// Grows with the words, and shrinks only with the window: what is around it stays in place.
void LiveFieldView::fitHeight() {
  const QMargins around = contentsMargins() + layout()->contentsMargins();
  const int needed_px = words_->heightForWidth(words_->width()) + around.top() + around.bottom();
  if (needed_px > minimumHeight()) setMinimumHeight(needed_px);
}

void LiveFieldView::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  if (event->size().width() != event->oldSize().width()) setMinimumHeight(sized(kLeastHeight_px));
  layout()->activate();  // the label's width is the new one
  fitHeight();
}

void LiveFieldView::showField() {
  const QString words = presenter_.words();
  if (words != words_->text()) {
    words_->setText(words);
    fitHeight();
  }
  const auto* shown = presenter_.shown();
  if (!shown || !(shown->peak > 0)) return bar_->set(tr("no field"), tr("V/m"), 0, std::nullopt);
  const double peak = presenter_.factor() * shown->peak;
  const int decimals = peak >= 10 ? 0 : peak >= 1 ? 1 : 2;
  bar_->set(presenter_.barWords(), presenter_.strengthUnit(), decimals, scene::fieldColours(peak));
}

}  // namespace facenav::ui
