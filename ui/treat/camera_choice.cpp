#include "treat/camera_choice.h"

#include <QComboBox>
#include <QLineEdit>
#include <QSignalBlocker>

#include "facenav/capture/stream_logins.h"
#include "facenav/core/shown_address.h"
#include "shell/shown_words.h"

namespace facenav::ui {

void letAddressBeTyped(QComboBox& box) {
  box.setEditable(true);
  box.setInsertPolicy(QComboBox::NoInsert);
  box.setCompleter(nullptr);  // it would replace an address by a listed camera's words
}

void listCameras(QComboBox& box, const std::vector<capture::FoundCamera>& devices, const QString& chosen) {
  auto* typed = box.lineEdit();
  const QString typing = typed && typed->hasFocus() && typed->isModified() ? typed->text() : QString();
  const QSignalBlocker block(&box);
  box.clear();
  for (const auto& device : devices) {
    box.addItem(shownWords(capture::inWords(device)),
                QString::fromStdString(capture::stableName(device.identity)));
    box.setItemData(box.count() - 1, box.itemText(box.count() - 1), Qt::ToolTipRole);
  }
  if (typed) {
    typed->setPlaceholderText(box.count() == 0 ? QComboBox::tr("no camera found: type an address")
                                               : QComboBox::tr("choose one, or type an address"));
    box.setCurrentIndex(chosen.isEmpty() ? -1 : box.findData(chosen));
    if (!typing.isEmpty())
      typed->setText(typing), typed->setModified(true);
    else if (box.currentIndex() < 0)
      box.setEditText(chosen);
    typed->setToolTip(box.currentText().isEmpty() ? box.toolTip() : box.currentText());
    typed->setCursorPosition(0);  // the beginning of long words is in view
    if (!typing.isEmpty()) typed->end(false);
    return;
  }
  box.setEnabled(box.count() > 0);
  if (box.count() == 0) box.addItem(QComboBox::tr("no camera found"), QString());
  box.setCurrentIndex(!box.isEnabled() ? 0 : chosen.isEmpty() ? -1 : box.findData(chosen));
}

QString chosenCamera(const QComboBox& box) {
  const int listed = box.isEditable() ? box.findText(box.currentText()) : box.currentIndex();
  return listed >= 0        ? box.itemData(listed).toString()
         : box.isEditable() ? box.currentText().trimmed()
                            : QString();
}

bool isAddress(const QString& camera) {
  for (const char* connection : {"v4l2:", "genicam:", "dc1394:"})
    if (camera.startsWith(connection)) return false;
  return !camera.isEmpty();
}

QString shownCamera(const QString& camera) {
  return QString::fromStdString(shownAddress(camera.toStdString()));
}

QString keptApart(const QString& camera) {
  return QString::fromStdString(capture::keptApart(camera.toStdString()));
}

QString addressTrouble(const std::vector<capture::FoundCamera>& devices, const QString& camera) {
  if (!isAddress(camera)) return {};
  try {
    capture::findCamera(devices, camera.toStdString());
  } catch (const Error& error) {
    return shownWords(error);
  }
  return {};
}

}  // namespace facenav::ui
