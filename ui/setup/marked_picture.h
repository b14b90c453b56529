#pragma once
// One camera's picture with what the set-up saw in it: face box, corners of the board, coil marker, and the
// parts of the picture that the views of the board cover.

#include <QImage>

#include "facenav/setup/rig_setup.h"

namespace facenav::ui {

/// Null where the view has no picture.
QImage markedPicture(const steps::SetupView& view, bool is_left);

}  // namespace facenav::ui
