#pragma once
// SliceTool: action of the left button on a slice in place of moving the crosshair: a stroke from press to
// release, in pixels of the shown plane.

#include <Eigen/Core>
#include <vector>

#include "facenav/volume/slice_plane.h"

namespace facenav::ui {

class SliceTool {
 public:
  virtual ~SliceTool() = default;
  /// Returns false if the view works as without a tool.
  virtual bool isActive() const = 0;
  /// `is_inverse`: Shift is held (remove, not add).
  virtual void press(const volume::SlicePlane& plane, const Eigen::Vector2d& at_px, bool is_inverse) = 0;
  virtual void drag(const volume::SlicePlane& plane, const Eigen::Vector2d& at_px) = 0;
  virtual void release(const volume::SlicePlane& plane) = 0;
  /// Radius of the ring at the pointer; 0: none.
  virtual double cursorRadius_mm() const = 0;
  /// Unfinished line of a lasso, pixels of the plane; empty: none.
  virtual const std::vector<Eigen::Vector2d>& outline() const = 0;
  /// Makes the tool larger (+1) or smaller (-1); Ctrl + wheel.
  virtual void resize(int steps) = 0;
};

}  // namespace facenav::ui
