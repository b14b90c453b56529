#pragma once
// What a box for the choice of a camera lists.

#include <QString>
#include <vector>

#include "facenav/capture/camera_backend.h"

class QComboBox;

namespace facenav::ui {

/// Lists the devices by their words; an item's data is the camera's stable name. `chosen`: the stable name of
/// the one that is selected; empty: none. Without devices the box says so and cannot be used. The box sends
/// no signals meanwhile.
void listCameras(QComboBox& box, const std::vector<capture::FoundCamera>& devices, const QString& chosen);

}  // namespace facenav::ui
