#pragma once
// The menu of a slice or a 3-D view, by a click of the right button without a drag, or the menu key.

#include <QPoint>
#include <QString>
#include <functional>
#include <optional>

#include "facenav/geometry/point.h"

class QMenu;
class QWidget;

namespace facenav::ui {

/// What a view offers in its menu. What it cannot do is left empty, and out of the menu.
struct ViewOffers {
  std::optional<Point<Mri>> place;  // under the pointer
  std::function<void()> goTo;       // moves the crosshair to `place`
  std::function<void()> reset;      // shows the whole again
};

/// Farthest that the right button moves in a click, px; farther is a drag, which zooms.
constexpr int kClickReach_px = 3;

/// "-38.0 -22.1 56.3": RAS, mm, as the field for typed coordinates reads it.
QString coordinatesAsText(const Point<Mri>& place);
/// Makes the menu of `view`; it deletes itself when it is closed.
QMenu* makeViewMenu(QWidget& view, const ViewOffers& offers);
/// Opens it at a place in the view.
void openViewMenu(QWidget& view, const QPoint& at, const ViewOffers& offers);

}  // namespace facenav::ui
