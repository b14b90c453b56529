#include "shell/window_header.h"

#include <QHBoxLayout>
#include <QLabel>

#include "shell/appearance.h"
#include "shell/elided_label.h"
#include "shell/status_chip.h"

namespace facenav::ui {

WindowHeader::WindowHeader(QWidget* parent)
    : QFrame(parent),
      case_words_(new ElidedLabel(this)),
      cameras_(new StatusChip(tr("CAMERAS no images"), this)),
      face_(new StatusChip(tr("FACE tracked"), this)),
      coil_(new StatusChip(tr("COIL tracked"), this)),
      timing_(new QLabel(this)) {
  setObjectName("header");
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(16, 8, 16, 8);
  auto* name = new QLabel(tr("FaceNav"), this);
  name->setObjectName("name");
  case_words_->setObjectName("muted");
  timing_->setObjectName("muted");
  timing_->setMinimumWidth(sized(170));
  timing_->setToolTip(
      tr("from a frame's arrival to its figures; frames left out because a newer one was there"));
  row->addWidget(name);
  row->addSpacing(12);
  row->addWidget(case_words_, 1);
  for (QWidget* widget :
       {static_cast<QWidget*>(cameras_), static_cast<QWidget*>(face_), static_cast<QWidget*>(coil_)})
    row->addWidget(widget);
  row->addWidget(timing_);
}

void WindowHeader::setCaseWords(const QString& words) { case_words_->set(words); }

void WindowHeader::setLive(const ReadOut& read_out) {
  cameras_->set(read_out.cameras);
  face_->set(read_out.face);
  coil_->set(read_out.coil);
  timing_->setText(read_out.timing);
}

void WindowHeader::showLiveStates(bool are_shown) {
  for (QWidget* widget : {static_cast<QWidget*>(cameras_), static_cast<QWidget*>(face_),
                          static_cast<QWidget*>(coil_), static_cast<QWidget*>(timing_)})
    widget->setVisible(are_shown);
}

}  // namespace facenav::ui
