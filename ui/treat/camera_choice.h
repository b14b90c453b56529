#pragma once
// Fills a box for the choice of a camera.

#include <QString>
#include <vector>

#include "facenav/capture/camera_backend.h"

class QComboBox;

namespace facenav::ui {

/// Lists the devices by their words; an item's data is the camera's stable name. `chosen`: stable name of the
/// selected camera; empty if none. Without devices the box shows that and is disabled. The box sends no
/// signals meanwhile.
void listCameras(QComboBox& box, const std::vector<capture::FoundCamera>& devices, const QString& chosen);

}  // namespace facenav::ui
