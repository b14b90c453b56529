#include "prepare/edit_panel.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QShortcut>
#include <QSignalBlocker>
#include <QSlider>
#include <cmath>

#include "shell/appearance.h"

namespace facenav::ui {
namespace {

constexpr int kWordLines = 3;
constexpr int kSliderPerMm = 2, kMostSlider = 40 * kSliderPerMm;

}  // namespace

EditPanel::EditPanel(EditPresenter& presenter, QWidget* parent)
    : QFrame(parent), presenter_(presenter), tools_(new QButtonGroup(this)) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(5);
  auto* heading = new QLabel(tr("Correct the brain"), this);
  heading->setObjectName("heading");
  grid->addWidget(heading, 0, 0, 1, 3);
  for (int column = 0; column < 3; ++column) grid->setColumnStretch(column, 1);
  addTools(*grid);
  size_words_ = new QLabel(this);
  size_ = new QSlider(Qt::Horizontal, this);
  size_->setAccessibleName(tr("size of the tool"));
  size_->setRange(1, kMostSlider);
  size_->setToolTip(
      tr("radius of brush and eraser, depth of the scalpel (Ctrl+wheel over a slice, [ and ])"));
  ball_ = new QCheckBox(tr("ball (3-D)"), this);
  ball_->setToolTip(tr("through neighbouring slices as well; else only the slice shown (D)"));
  ball_->setShortcut(Qt::Key_D);
  for (const int step : {-1, 1}) {
    auto* key = new QShortcut(step < 0 ? Qt::Key_BracketLeft : Qt::Key_BracketRight, this);
    key->setWhatsThis(step < 0 ? tr("smaller brush, shallower scalpel") : tr("larger brush, deeper scalpel"));
    connect(key, &QShortcut::activated, this, [this, step] {
      cuts() ? presenter_.setCutDepth_mm(presenter_.cutDepth_mm() + step) : presenter_.resize(step);
    });
  }
  grid->addWidget(size_words_, 3, 0);
  grid->addWidget(size_, 3, 1);
  grid->addWidget(ball_, 3, 2);
  addActions(*grid, 4);
  words_ = new QLabel(this);
  words_->setObjectName("muted");
  words_->setWordWrap(true);
  words_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  whenTextScales(this, [this] {  // buttons stay where they are
    words_->ensurePolished();
    words_->setMinimumHeight(kWordLines * words_->fontMetrics().lineSpacing());
  });
  grid->addWidget(words_, 9, 0, 1, 3);
  connect(size_, &QSlider::valueChanged, this, [this](int value) {
    const double size_mm = double(value) / kSliderPerMm;
    cuts() ? presenter_.setCutDepth_mm(size_mm) : presenter_.setRadius_mm(size_mm);
  });
  connect(ball_, &QCheckBox::toggled, &presenter_, &EditPresenter::setBall);
  connect(&presenter_, &EditPresenter::changed, this, &EditPanel::showState);
  showState();
}

QPushButton* EditPanel::button(const QString& text, const QString& tip, const QKeySequence& key) {
  auto* made = new QPushButton(text, this);
  made->setObjectName("tool");
  made->setToolTip(key.isEmpty() ? tip : tr("%1 (%2)").arg(tip, key.toString(QKeySequence::NativeText)));
  if (!key.isEmpty()) made->setShortcut(key);
  return made;
}

void EditPanel::addTools(QGridLayout& grid) {
  struct Entry {
    EditTool tool;
    QString text, tip;
    QKeySequence key;
  };
  const Entry entries[] = {
      {EditTool::brush, tr("Brush"), tr("add to the brain; Shift takes away"), Qt::Key_B},
      {EditTool::eraser, tr("Eraser"), tr("take away; Shift adds"), Qt::Key_E},
      {EditTool::threshold, tr("Threshold"), tr("brush that takes only what looks like the place pressed"),
       Qt::Key_H},
      {EditTool::lasso, tr("Lasso"), tr("draw round what is to be added; Shift cuts it off"), Qt::Key_L},
      {EditTool::grow, tr("Grow"), tr("add the connected region of similar values; Shift removes it"),
       Qt::Key_G},
      {EditTool::scalpel, tr("Scalpel"),
       tr("draw round a part on the 3-D view: what lies behind it, down to the depth, is cut off"),
       Qt::Key_X}};
  int place = 0;
  for (const auto& entry : entries) {
    auto* made = button(entry.text, entry.tip, entry.key);
    made->setCheckable(true);
    tools_->addButton(made, int(entry.tool));
    grid.addWidget(made, 1 + place / 3, place % 3);
    ++place;
  }
  tools_->setExclusive(false);  // so that the active tool can be switched off
  connect(tools_, &QButtonGroup::idClicked, this, [this](int id) { presenter_.setTool(EditTool(id)); });
}

void EditPanel::addActions(QGridLayout& grid, int row) {
  auto* smooth = button(tr("Smooth"), tr("shave spikes off and fill notches"), Qt::Key_S);
  auto* fill = button(tr("Fill holes"), tr("what the brain encloses becomes brain"), Qt::Key_F);
  auto* interpolate =
      button(tr("Interpolate"), tr("the slices between those drawn on, in one orientation"), Qt::Key_I);
  undo_ = button(tr("Undo"), tr("undo"), QKeySequence::Undo);
  redo_ = button(tr("Redo"), tr("redo"), QKeySequence::Redo);
  auto* reset = button(tr("Automatic"), tr("back to the automatic mask, as a step that can be undone"), {});
  save_ = button(tr("Save"), tr("into the case; a sign-off is void then"), QKeySequence::Save);
  discard_ = button(tr("Discard"), tr("throw the draft away: the case's own mask again"), {});
  auto* automatic = new QCheckBox(tr("automatic contour, white"), this);
  automatic->setToolTip(tr("show the automatic mask's contour as well, white (A)"));
  automatic->setShortcut(Qt::Key_A);
  int place = 0;
  grid.addWidget(automatic, row + 3, 0, 1, 3);
  for (QWidget* each :
       {static_cast<QWidget*>(smooth), static_cast<QWidget*>(fill), static_cast<QWidget*>(interpolate),
        static_cast<QWidget*>(undo_), static_cast<QWidget*>(redo_), static_cast<QWidget*>(reset),
        static_cast<QWidget*>(save_), static_cast<QWidget*>(discard_)}) {
    grid.addWidget(each, row + place / 3, place % 3);
    ++place;
  }
  connect(smooth, &QPushButton::clicked, &presenter_, &EditPresenter::smooth);
  connect(fill, &QPushButton::clicked, &presenter_, &EditPresenter::fillHoles);
  connect(interpolate, &QPushButton::clicked, &presenter_, &EditPresenter::interpolate);
  connect(undo_, &QPushButton::clicked, &presenter_, &EditPresenter::undo);
  connect(redo_, &QPushButton::clicked, &presenter_, &EditPresenter::redo);
  connect(reset, &QPushButton::clicked, &presenter_, &EditPresenter::resetToAutomatic);
  connect(save_, &QPushButton::clicked, &presenter_, &EditPresenter::save);
  connect(discard_, &QPushButton::clicked, &presenter_, &EditPresenter::discard);
  connect(automatic, &QCheckBox::toggled, this, &EditPanel::automaticShown);
}

bool EditPanel::cuts() const { return presenter_.tool() == EditTool::scalpel; }

void EditPanel::showState() {
  for (auto* each : tools_->buttons()) each->setChecked(EditTool(tools_->id(each)) == presenter_.tool());
  const QSignalBlocker quiet(size_);
  const double size_mm = cuts() ? presenter_.cutDepth_mm() : presenter_.radius_mm();
  size_->setValue(int(std::lround(size_mm * kSliderPerMm)));
  size_words_->setText((cuts() ? tr("%1 mm deep") : tr("%1 mm")).arg(size_mm, 0, 'f', 1));
  ball_->setEnabled(!cuts());
  undo_->setEnabled(presenter_.canUndo());
  redo_->setEnabled(presenter_.canRedo());
  save_->setEnabled(presenter_.hasUnsaved());
  discard_->setEnabled(presenter_.hasUnsaved());
  words_->setText(presenter_.words());
  setEnabled(presenter_.canEdit());
}

}  // namespace facenav::ui
