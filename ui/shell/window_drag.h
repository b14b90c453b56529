#pragma once
// Window and level by dragging, the same in every slice view.

#include <QPoint>
#include <algorithm>

#include "facenav/scene/slice_scene.h"

namespace facenav::ui {

/// Changes the window by a drag: right widens it, down raises the level.
inline void dragWindow(scene::SliceScene& scene, const QPoint& step_px) {
  const double range = std::max(1e-3, scene.white - scene.black);
  const double width = range * (1.0 + 0.005 * step_px.x());
  const double level = 0.5 * (scene.white + scene.black) + range * 0.003 * step_px.y();
  scene.black = level - 0.5 * width;
  scene.white = level + 0.5 * width;
}

}  // namespace facenav::ui
