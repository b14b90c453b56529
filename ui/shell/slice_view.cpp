#include "shell/slice_view.h"

#include <QContextMenuEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolButton>
#include <QWheelEvent>
#include <algorithm>

#include "shell/image_view.h"
#include "shell/picture_focus.h"
#include "shell/theme.h"
#include "shell/window_drag.h"

namespace facenav::ui {
namespace {

QString nameOf(volume::Anatomical orientation) {
  switch (orientation) {
    case volume::Anatomical::axial:
      return SliceView::tr("axial");
    case volume::Anatomical::coronal:
      return SliceView::tr("coronal");
    case volume::Anatomical::sagittal:
      return SliceView::tr("sagittal");
  }
  return {};
}

}  // namespace

SliceView::SliceView(volume::Anatomical orientation, QWidget* parent)
    : QWidget(parent), orientation_(orientation), reset_(new QToolButton(this)) {
  setMinimumSize(160, 140);
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("slice, %1").arg(nameOf(orientation)));
  setToolTip(
      tr("left: crosshair   wheel, page up and down: slice   right: zoom   middle: pan   Ctrl+left: "
         "window/level   double "
         "click: choose   R: zoom, pan and window as at first   right click: menu"));
  reset_->setText(tr("1:1"));
  reset_->setObjectName("on_picture");
  reset_->setToolTip(tr("zoom, pan and window as at first, in all slices (R)"));
  connect(reset_, &QToolButton::clicked, this, &SliceView::resetWanted);
}

void SliceView::setScene(std::shared_ptr<scene::SliceScene> scene) {
  scene_ = std::move(scene);
  reset();
}

void SliceView::reset() {
  zoom_ = 1.0;
  pan_mm_.setZero();
  refresh();
}

void SliceView::setTool(SliceTool* tool) {
  tool_ = tool;
  setMouseTracking(tool != nullptr);  // for the brush's ring at the pointer
}

void SliceView::refresh() {
  is_outdated_ = true;
  update();
}

volume::SlicePlane SliceView::plane() const {
  const auto& grid = scene_->mri->grid;
  const Point<Mri> through = scene_->crosshair.value_or(grid.centre());
  volume::SlicePlane plane = volume::anatomicalPlane(grid, orientation_, through);
  const double whole_width_mm = plane.width, whole_height_mm = plane.height;
  const Eigen::Vector3d centre = plane.toMri(0.5 * (plane.width - 1), 0.5 * (plane.height - 1)).mm +
                                 pan_mm_.x() * plane.right.v + pan_mm_.y() * plane.down.v;
  plane.width = std::max(16, width());
  plane.height = std::max(16, height());
  plane.spacing_mm = std::max(whole_width_mm / plane.width, whole_height_mm / plane.height) * 1.04 / zoom_;
  plane.origin = Point<Mri>(centre - plane.spacing_mm * (0.5 * (plane.width - 1) * plane.right.v +
                                                         0.5 * (plane.height - 1) * plane.down.v));
  return plane;
}

Point<Mri> SliceView::pointAt(const QPoint& position) const {
  return plane().toMri(position.x(), position.y());
}

void SliceView::moveCrosshair(const Point<Mri>& to) { emit crosshairMoved(to.mm.x(), to.mm.y(), to.mm.z()); }

void SliceView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), themeColour(Colour::picture));
  if (!scene_ || !scene_->mri) {
    painter.setPen(themeColour(Colour::picture_words));
    painter.drawText(rect(), Qt::AlignCenter, nameOf(orientation_));
    return paintFocus(painter, *this);
  }
  if (is_outdated_) picture_ = toQImage(scene_->picture(plane()));
  is_outdated_ = false;
  painter.drawImage(0, 0, picture_);
  paintCaption(painter);
  if (draws()) paintTool(painter);
  paintFocus(painter, *this);
}

QStringList SliceView::caption() const {
  if (!scene_ || !scene_->mri) return {};
  const auto shown = plane();
  const auto slice = volume::sliceNumber(scene_->mri->grid, shown);
  const auto position = scene::positionOf(shown);
  const auto value = scene_->valueAtCrosshair();
  return {tr("%1  %2/%3")
              .arg(nameOf(orientation_),
                   slice.number > 0 ? QString::number(slice.number) : QString(QChar(0x2013)))
              .arg(slice.count),
          tr("%1 %2 mm").arg(QLatin1Char(position.side)).arg(position.distance_mm, 0, 'f', 1),
          value ? tr("value %1").arg(double(*value), 0, 'g', 5) : tr("outside the scan")};
}

void SliceView::paintCaption(QPainter& painter) {
  painter.setPen(themeColour(Colour::picture_words));
  const QFontMetrics metrics = painter.fontMetrics();
  int y_px = 4 + metrics.ascent();
  for (const QString& line : caption()) {
    painter.drawText(8, y_px, metrics.elidedText(line, Qt::ElideRight, reset_->x() - 12));
    y_px += metrics.lineSpacing();
  }
}

void SliceView::paintTool(QPainter& painter) {
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(themeColour(Colour::picture_text), 1.4));
  if (is_stroke_ && !tool_->outline().empty()) {
    QPolygonF line;
    for (const auto& p : tool_->outline()) line << QPointF(p.x(), p.y());
    painter.drawPolyline(line);
  }
  const double radius_px = tool_->cursorRadius_mm() / plane().spacing_mm;
  if (pointer_.x() >= 0 && radius_px > 0) painter.drawEllipse(QPointF(pointer_), radius_px, radius_px);
}

void SliceView::leaveEvent(QEvent*) {
  pointer_ = {-1, -1};
  if (draws()) update();
}

ViewOffers SliceView::offersAt(const QPoint& position) {
  ViewOffers offers;
  if (!scene_ || !scene_->mri) return offers;
  offers.place = pointAt(position);
  offers.goTo = [this, at = *offers.place] { moveCrosshair(at); };
  offers.reset = [this] { emit resetWanted(); };
  return offers;
}

/// Opens the menu for the menu key; the mouse opens it where the right button is released without a drag.
void SliceView::contextMenuEvent(QContextMenuEvent* event) {
  if (event->reason() != QContextMenuEvent::Mouse)
    openViewMenu(*this, rect().center(), offersAt(rect().center()));
}

void SliceView::mousePressEvent(QMouseEvent* event) {
  last_ = event->pos();
  pressed_at_ = event->pos();
  if (!scene_ || !scene_->mri || event->button() != Qt::LeftButton ||
      event->modifiers() & Qt::ControlModifier)
    return;
  if (!draws()) return moveCrosshair(pointAt(event->pos()));
  is_stroke_ = true;
  tool_->press(plane(), Eigen::Vector2d(event->pos().x(), event->pos().y()),
               event->modifiers() & Qt::ShiftModifier);
  refresh();
}

void SliceView::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::RightButton && (event->pos() - pressed_at_).manhattanLength() <= kClickReach_px)
    openViewMenu(*this, event->pos(), offersAt(event->pos()));
  if (!is_stroke_ || event->button() != Qt::LeftButton) return;
  is_stroke_ = false;
  tool_->release(plane());
  refresh();
}

void SliceView::mouseMoveEvent(QMouseEvent* event) {
  if (!scene_ || !scene_->mri) return;
  const QPoint step = event->pos() - last_;
  last_ = pointer_ = event->pos();
  if (is_stroke_) {
    tool_->drag(plane(), Eigen::Vector2d(event->pos().x(), event->pos().y()));
    return refresh();
  }
  if (draws() && event->buttons() == Qt::NoButton) return update();
  if (event->buttons() & Qt::LeftButton && event->modifiers() & Qt::ControlModifier) {
    dragWindow(*scene_, step);
    emit windowChanged();
  } else if (event->buttons() & Qt::LeftButton && !draws()) {
    moveCrosshair(pointAt(event->pos()));
  } else if (event->buttons() & Qt::RightButton) {
    if ((event->pos() - pressed_at_).manhattanLength() <= kClickReach_px) return;
    zoom_ = std::clamp(zoom_ * (1.0 - 0.01 * step.y()), 0.5, 12.0);
    refresh();
  } else if (event->buttons() & Qt::MiddleButton) {
    pan_mm_ -= plane().spacing_mm * Eigen::Vector2d(step.x(), step.y());
    refresh();
  }
}

void SliceView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (!scene_ || !scene_->mri || draws()) return;
  const auto p = pointAt(event->pos());
  emit chosen(p.mm.x(), p.mm.y(), p.mm.z());
}

void SliceView::wheelEvent(QWheelEvent* event) {
  if (!scene_ || !scene_->mri) return;
  if (draws() && event->modifiers() & Qt::ControlModifier) {
    tool_->resize(event->angleDelta().y() > 0 ? 1 : -1);
    return update();
  }
  goBy(event->angleDelta().y() > 0 ? 1.0 : -1.0);
}

void SliceView::keyPressEvent(QKeyEvent* event) {
  const bool is_up = event->key() == Qt::Key_PageUp;
  if (!scene_ || !scene_->mri || (!is_up && event->key() != Qt::Key_PageDown))
    return QWidget::keyPressEvent(event);
  goBy(is_up ? 1.0 : -1.0);
}

/// Moves the crosshair across the slice.
void SliceView::goBy(double step_mm) {
  const auto p = plane();
  const Eigen::Vector3d normal = p.right.v.cross(p.down.v);
  const Eigen::Vector3d from = scene_->crosshair.value_or(scene_->mri->grid.centre()).mm;
  moveCrosshair(Point<Mri>(from - step_mm * normal));
}

void SliceView::resizeEvent(QResizeEvent*) {
  reset_->adjustSize();
  reset_->move(width() - reset_->width() - 2, 2);
  refresh();
}

}  // namespace facenav::ui
