#pragma once
// Boxes for the choice of a camera: from the connected ones, or by an address that is typed.

#include <QString>
#include <vector>

#include "facenav/capture/camera_backend.h"

class QComboBox;

namespace facenav::ui {

/// Lets an address be typed into the box: rtsp://.., /dev/video2, 2, a video, a folder of pictures.
void letAddressBeTyped(QComboBox& box);
/// Lists the devices by their words; an item's data is the camera's stable name. `chosen`: stable name of the
/// selected camera, or an address as typed; empty if none. The box sends no signals meanwhile.
void listCameras(QComboBox& box, const std::vector<capture::FoundCamera>& devices, const QString& chosen);
/// The stable name of the selected camera, or the address as typed; empty if there is neither.
QString chosenCamera(const QComboBox& box);
/// True for an address, false for the stable name of a connected camera.
bool isAddress(const QString& camera);
/// An address as it may be shown: without its password. A stable name stays.
QString shownCamera(const QString& camera);
/// Keeps the password of an address in the user's own file (capture/stream_logins.h) and returns the address
/// without it. Throws Error if it cannot be kept.
QString keptApart(const QString& camera);
/// Why nothing can be opened at an address, in words; empty if it may be, and for a connected camera.
QString addressTrouble(const std::vector<capture::FoundCamera>& devices, const QString& camera);

}  // namespace facenav::ui
