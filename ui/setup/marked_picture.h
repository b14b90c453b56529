#pragma once
// One camera's picture with what the set-up detected in it: face box, corners of the board, coil marker, and
// the parts of the picture that the views of the board cover.

#include <QImage>

#include "facenav/setup/rig_setup.h"

namespace facenav::ui {

/// Draws the picture; null if the view has none.
QImage markedPicture(const steps::SetupView& view, bool is_left);

}  // namespace facenav::ui
