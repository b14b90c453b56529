#include "plan/place_panel.h"

#include <QComboBox>
#include <QFontDatabase>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QVBoxLayout>
#include <algorithm>

#include "shell/appearance.h"
#include "shell/narrow_label.h"

namespace facenav::ui {
namespace {

constexpr int kLines = 4;  // RAS, MNI, the region, its Brodmann area

}  // namespace

PlacePanel::PlacePanel(PlacePresenter& presenter, QWidget* parent)
    : QFrame(parent), presenter_(presenter), words_(new QLabel(this)), fault_(new QLabel(this)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  auto* heading = new QLabel(tr("Crosshair"), this);
  heading->setObjectName("heading");
  words_->setObjectName("figures_text");
  words_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  words_->setToolTip(tr("mm; RAS of the patient's scan, MNI and labels through the atlas registered to it"));
  makeNarrow(*words_);
  whenTextScales(this, [this] { leaveRoom(); });
  frame_ = new QComboBox(this);
  frame_->setAccessibleName(tr("what the typed numbers are"));
  frame_->addItems({tr("MNI"), tr("RAS")});
  frame_->setToolTip(tr("what the typed numbers are"));
  typed_ = new QLineEdit(this);
  typed_->setAccessibleName(tr("coordinates x y z, mm"));
  typed_->setPlaceholderText(tr("x y z, mm"));
  typed_->setToolTip(
      tr("type coordinates, such as -38 -22 56 or -38,5; -22; 56; Return: the crosshair goes there "
         "(Ctrl+G)"));
  target_ = new QPushButton(tr("Target here"), this);
  target_->setObjectName("tool");
  target_->setToolTip(tr("a target at the cortex under the crosshair (Ctrl+T)"));
  target_->setShortcut(Qt::CTRL + Qt::Key_T);
  fault_->setObjectName("fault");
  makeNarrow(*fault_);
  fault_->hide();
  auto* row = new QHBoxLayout;
  row->addWidget(frame_);
  row->addWidget(typed_, 1);
  auto* top = new QHBoxLayout;  // in one row: the list of targets needs the height
  top->addWidget(heading, 1);
  top->addWidget(target_);
  column->addLayout(top);
  column->addWidget(words_);
  column->addLayout(row);
  column->addWidget(fault_);
  connect(typed_, &QLineEdit::returnPressed, this, &PlacePanel::read);
  connect(target_, &QPushButton::clicked, this,
          [this] { emit targetWanted(crosshair_.mm.x(), crosshair_.mm.y(), crosshair_.mm.z()); });
}

void PlacePanel::show(const Point<Mri>& crosshair) {
  crosshair_ = crosshair;
  const QString words = presenter_.describe(crosshair);
  const int fewer = std::max(0, kLines - 1 - int(words.count('\n')));
  words_->setText(words + QString(fewer, '\n'));  // the fields stay in place
  leaveRoom();
  if (!presenter_.hasAtlas()) frame_->setCurrentIndex(1);
}

void PlacePanel::leaveRoom() {
  int longest_px = 0;
  for (const QString& word : words_->text().split(QRegularExpression("\\s+")))
    longest_px = std::max(longest_px, words_->fontMetrics().horizontalAdvance(word));
  words_->setMinimumWidth(longest_px);
  keepLines(*words_);
}

void PlacePanel::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  layout()->activate();  // the label's width is the new one
  keepLines(*words_);
}

void PlacePanel::takeFocus() {
  typed_->setFocus();
  typed_->selectAll();
}

void PlacePanel::read() {
  QString why;
  const auto place = presenter_.read(typed_->text(), frame_->currentIndex() == 0, why);
  fault_->setText(why);
  fault_->setVisible(!why.isEmpty());
  if (place) emit goTo(place->mm.x(), place->mm.y(), place->mm.z());
}

}  // namespace facenav::ui
