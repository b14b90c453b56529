#pragma once
// Work area: the part of the screen that a window may cover, without the desktop's bars. A window starts
// inside it with its frame, so that its status line and its buttons are on the screen.

#include <QMargins>
#include <QRect>

class QScrollArea;
class QWidget;

namespace facenav::ui {

/// Geometry of a window's content (without its frame), in the middle of the work area: as large as wanted
/// where content and frame fit, else as large as they fit.
QRect fittedInto(const QRect& work_area, const QSize& wanted, const QMargins& frame);
/// Gives a window its usual size at the present size of text, or what fits. `usual`: at normal text. A window
/// that is not shown yet is fitted once more when the desktop has given it its frame.
void fitIntoWorkArea(QWidget& window, const QSize& usual);
/// Makes an area that scrolls its content only where the window is smaller than the content needs.
QScrollArea* scrolledIfSmall(QWidget* content, QWidget* parent);

}  // namespace facenav::ui
