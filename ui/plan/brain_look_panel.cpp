#include "plan/brain_look_panel.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>
#include <cmath>

#include "prepare/distance_legend.h"
#include "shell/appearance.h"
#include "shell/words_of_button.h"

namespace facenav::ui {
namespace {

constexpr int kStepsPerMm = 2, kBeside = 3;

}  // namespace

BrainLookPanel::BrainLookPanel(CortexPresenter& presenter, QWidget* parent)
    : QFrame(parent), presenter_(presenter), looks_(new QButtonGroup(this)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  auto* row = new QHBoxLayout;
  const QString names[] = {tr("\u03c6\u2013\u03b8 model"), tr("Cortex"), tr("Distance"), tr("Side by side")};
  const QString tips[] = {
      tr("the brain as the phi-theta model draws it (Shift+1)"),
      tr("the true surface, both banks of every sulcus, with the MRI at the peel depth (Shift+2)"),
      tr("the true surface, coloured by its distance from the phi-theta model (Shift+3)"),
      tr("the phi-theta model and, beside it, its distance from the true surface (Shift+4)")};
  for (int i = 0; i <= kBeside; ++i) {
    auto* button = new QPushButton(names[i], this);
    button->setObjectName("tool");
    button->setCheckable(true);
    button->setToolTip(tips[i]);
    button->setShortcut(QKeySequence(Qt::SHIFT + Qt::Key_1 + i));
    leaveRoomForBold(*button);
    looks_->addButton(button, i);
    row->addWidget(button);
  }
  peel_ = new QSlider(Qt::Horizontal, this);
  peel_->setRange(0, scene::kMostPeel_mm * kStepsPerMm);
  peel_->setPageStep(2 * kStepsPerMm);
  peel_->setAccessibleName(tr("peel depth"));
  peel_->setToolTip(tr("how deep below the surface the MRI is shown, 0 to 40 mm (arrows, Page up and down)"));
  peel_words_ = new QLabel(this);
  whenTextScales(this, [this] { peel_words_->setMinimumWidth(sized(110)); });
  column->addLayout(row);
  auto* below_box = new QWidget(this);
  whenTextScales(below_box, [below_box] {
    below_box->setMinimumHeight(sized(36));  // fixed, so that the view above keeps its size
  });
  auto* below = new QHBoxLayout(below_box);
  below->setContentsMargins(0, 0, 0, 0);
  below->addWidget(peel_, 1);
  below->addWidget(peel_words_);
  legend_ = new DistanceLegend(this);
  words_ = new QLabel(this);
  words_->setObjectName("muted");
  words_->setWordWrap(true);
  words_->setToolTip(tr("of the distances between the phi-theta model and the true surface, all vertices"));
  below->addWidget(legend_, 1);
  below->addWidget(words_, 1);
  column->addWidget(below_box);
  connect(looks_, &QButtonGroup::idClicked, this, [this](int id) {
    id == kBeside ? presenter_.setBesideModel() : presenter_.setLook(scene::BrainLook(id));
  });
  connect(peel_, &QSlider::valueChanged, this,
          [this](int value) { presenter_.setPeel_mm(double(value) / kStepsPerMm); });
  connect(&presenter_, &CortexPresenter::changed, this, &BrainLookPanel::showState);
  showState();
}

void BrainLookPanel::showState() {
  const auto look = presenter_.look();
  looks_->button(presenter_.isBesideModel() ? kBeside : int(look))->setChecked(true);
  for (auto* button : looks_->buttons())
    button->setEnabled(presenter_.isPossible() || looks_->id(button) == int(scene::BrainLook::model));
  const bool peels = look != scene::BrainLook::distance;
  const QSignalBlocker quiet(peel_);
  peel_->setValue(int(std::lround(presenter_.peel_mm() * kStepsPerMm)));
  peel_->setEnabled(look == scene::BrainLook::cortex && presenter_.cortex());
  peel_->setVisible(peels);
  peel_words_->setVisible(peels);
  peel_words_->setText(tr("peel %1 mm").arg(presenter_.peel_mm(), 0, 'f', 1));
  legend_->setVisible(!peels && presenter_.cortex());
  if (presenter_.cortex()) legend_->setScale(presenter_.scale_mm());
  words_->setText(presenter_.words());
  words_->setVisible(!presenter_.words().isEmpty());
}

}  // namespace facenav::ui
