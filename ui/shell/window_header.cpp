#include "shell/window_header.h"

#include <QHBoxLayout>
#include <QLabel>

#include "shell/appearance.h"
#include "shell/elided_label.h"
#include "shell/status_chip.h"
#include "shell/users_words.h"

namespace facenav::ui {
namespace {

constexpr int kGap_px = 40;  // between the name, the case and the states

}  // namespace

WindowHeader::WindowHeader(QWidget* parent)
    : QFrame(parent),
      case_words_(new ElidedLabel(this)),
      cameras_(new StatusChip(tr("CAMERAS no images"), this)),
      face_(new StatusChip(tr("FACE tracked"), this)),
      coil_(new StatusChip(tr("COIL tracked"), this)),
      name_(new QLabel(tr("FaceNav"), this)),
      timing_(new QLabel(this)) {
  setObjectName("header");
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(16, 8, 16, 8);
  name_->setObjectName("name");
  case_words_->setObjectName("muted");
  markUsersWords(*case_words_);  // the label of the case
  timing_->setObjectName("muted");
  whenTextScales(this, [this] {
    timing_->setMinimumWidth(sized(170));
    if (isVisible()) fit();
  });
  timing_->setToolTip(
      tr("from a frame's arrival to its figures; frames left out because a newer one was there"));
  row->addWidget(name_);
  row->addSpacing(12);
  row->addWidget(case_words_, 1);
  for (QWidget* widget :
       {static_cast<QWidget*>(cameras_), static_cast<QWidget*>(face_), static_cast<QWidget*>(coil_)})
    row->addWidget(widget);
  row->addWidget(timing_);
}

void WindowHeader::setCaseWords(const QStringList& parts) { case_words_->setParts(parts); }

void WindowHeader::setLive(const ReadOut& read_out) {
  cameras_->set(read_out.cameras);
  face_->set(read_out.face);
  coil_->set(read_out.coil);
  timing_->setText(read_out.timing);
}

void WindowHeader::showLiveStates(bool are_shown) {
  are_live_ = are_shown;
  for (auto* chip : {cameras_, face_, coil_}) chip->setVisible(are_shown);
  fit();
}

QSize WindowHeader::minimumSizeHint() const {
  const QMargins margins = layout()->contentsMargins();
  int width_px = margins.left() + margins.right();
  for (const auto* chip : {cameras_, face_, coil_})
    if (are_live_) width_px += chip->sizeHint().width() + layout()->spacing();
  return {width_px, QFrame::minimumSizeHint().height()};
}

/// Hides what there is no room for; the live states are always shown.
void WindowHeader::fit() {
  const int room_px = width() - minimumSizeHint().width() - sized(kGap_px);
  const int name_px = name_->sizeHint().width();
  name_->setVisible(name_px <= room_px);
  timing_->setVisible(are_live_ && name_px + timing_->minimumWidth() <= room_px);
}

void WindowHeader::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  fit();
}

}  // namespace facenav::ui
