#include "treat/camera_choice.h"

#include <QComboBox>
#include <QSignalBlocker>

namespace facenav::ui {

void listCameras(QComboBox& box, const std::vector<capture::FoundCamera>& devices, const QString& chosen) {
  const QSignalBlocker block(&box);
  box.clear();
  for (const auto& device : devices) {
    box.addItem(QString::fromStdString(capture::inWords(device)),
                QString::fromStdString(capture::stableName(device.identity)));
    box.setItemData(box.count() - 1, box.itemText(box.count() - 1), Qt::ToolTipRole);
  }
  box.setEnabled(box.count() > 0);
  if (box.count() == 0) box.addItem(QComboBox::tr("no camera found"), QString());
  box.setCurrentIndex(!box.isEnabled() ? 0 : chosen.isEmpty() ? -1 : box.findData(chosen));
}

}  // namespace facenav::ui
