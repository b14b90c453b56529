#include "setup/camera_fields.h"

#include <QComboBox>
#include <QEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "shell/narrow_label.h"
#include "shell/users_words.h"
#include "treat/camera_choice.h"

namespace facenav::ui {

CameraFields::CameraFields(SetupPresenter& presenter, QWidget* parent)
    : QWidget(parent), presenter_(presenter) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  const QString also = tr("; or type an address: rtsp://.., /dev/video2, a video, a folder of pictures");
  left_ = addField(*column, tr("Left camera"),
                   tr("the camera on the left, seen from behind the pair, facing the patient") + also,
                   SetupField::left);
  right_ = addField(*column, tr("Right camera"),
                    tr("the camera on the right, seen from behind the pair, facing the patient") + also,
                    SetupField::right);
  size_ = addField(*column, tr("Size of the pictures"), tr("width x height, px; both cameras must have it"),
                   SetupField::size);
  size_->addItems(SetupPresenter::sizes());
  size_->setCurrentText(presenter_.chosenSize());
  connect(size_, &QComboBox::currentTextChanged, &presenter_, &SetupPresenter::chooseSize);
  for (auto* box : {left_, right_}) {
    markUsersWords(*box);  // a camera's name is its maker's, and may be longer than the box
    connect(box, QOverload<int>::of(&QComboBox::activated), this, &CameraFields::choose);
    connect(box->lineEdit(), &QLineEdit::editingFinished, this, &CameraFields::choose);
  }
  refresh();
}

QComboBox* CameraFields::addField(QVBoxLayout& column, const QString& name, const QString& tip,
                                  SetupField field) {
  auto* title = new QLabel(name, this);
  auto* box = new QComboBox(this);
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(8);  // the layout decides the width, not the longest name
  box->setToolTip(tip);
  box->setAccessibleDescription(tip);
  letAddressBeTyped(*box);
  box->lineEdit()->installEventFilter(this);
  title->setBuddy(box);
  auto* trouble = new QLabel(this);
  trouble->setObjectName("fault");
  makeNarrow(*trouble);
  trouble->hide();
  troubles_[int(field)] = trouble;
  column.addWidget(title);
  column.addWidget(box);
  column.addWidget(trouble);
  return box;
}

void CameraFields::choose() {
  const QString left = chosenCamera(*left_), right = chosenCamera(*right_);
  if (left != presenter_.left() || right != presenter_.right()) presenter_.choose(left, right);
}

void CameraFields::refresh() {
  listCameras(*left_, presenter_.devices(), presenter_.left());
  listCameras(*right_, presenter_.devices(), presenter_.right());
  for (auto* box : {left_, right_})
    box->setToolTip(box->currentText().isEmpty() ? box->accessibleDescription() : box->currentText());
  for (const auto field : {SetupField::left, SetupField::right, SetupField::size}) {
    auto* label = troubles_[int(field)];
    label->setText(presenter_.trouble(field));
    label->setVisible(!label->text().isEmpty());
  }
}

bool CameraFields::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Return || key == Qt::Key_Enter) event->accept();
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace facenav::ui
