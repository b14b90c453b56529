#include "plan/coil_slice_view.h"

#include <QContextMenuEvent>
#include <QMetaMethod>
#include <QMouseEvent>
#include <QPainter>
#include <QRegularExpression>
#include <algorithm>

#include "facenav/guidance/handle.h"
#include "shell/appearance.h"
#include "shell/image_view.h"
#include "shell/picture_focus.h"
#include "shell/theme.h"
#include "shell/window_drag.h"

namespace facenav::ui {
namespace {

/// Returns the longest wording that fits: "along: cortex 27 mm below the scalp", that without "along", or "27
/// mm". A figure that is cut off would be misread.
QString longestFitting(const QString& words, const QFontMetrics& metrics, int room_px) {
  static const QRegularExpression kFigure("[0-9.]+ mm");
  for (const QString& shorter : {words, words.section(": ", -1)})
    if (metrics.horizontalAdvance(shorter) <= room_px) return shorter;
  const auto figure = kFigure.match(words);
  return figure.hasMatch() ? figure.captured() : metrics.elidedText(words, Qt::ElideRight, room_px);
}

}  // namespace

CoilSliceView::CoilSliceView(scene::CoilCut cut, QWidget* parent) : QWidget(parent), cut_(cut) {
  setMinimumSize(150, 110);
  setFocusPolicy(Qt::StrongFocus);  // the arrow keys of Plan, and the menu key
  setAccessibleName(cut == scene::CoilCut::along_handle ? tr("slice along the handle")
                                                        : tr("slice across the handle"));
  setToolTip(cut == scene::CoilCut::along_handle
                 ? tr("the MRI along the coil's axis and its handle, which is on the left; a tick is 10 mm; "
                      "ring and lines beside the beam: 95 % of the errors at the target are smaller")
                 : tr("the MRI along the coil's axis and across its handle, as seen by the one who holds it; "
                      "a tick is 10 mm; ring and lines beside the beam: 95 % of the errors at the target are "
                      "smaller"));
}

void CoilSliceView::setScene(std::shared_ptr<scene::SliceScene> scene) {
  scene_ = std::move(scene);
  reset();
}

void CoilSliceView::setCoil(const std::optional<scene::SlicedCoil>& coil, const QString& words) {
  if (!coil && !coil_ && words == words_) return;
  coil_ = coil;
  words_ = words;
  refresh();
}

void CoilSliceView::refresh() {
  is_outdated_ = true;
  update();
}

void CoilSliceView::reset() {
  zoom_ = 1.0;
  refresh();
}

volume::SlicePlane CoilSliceView::plane() const {
  return scene::coilPlane(coil_->mri_T_coil, cut_, width(), height(), zoom_);
}

QString CoilSliceView::caption() const {
  const QString name =
      cut_ == scene::CoilCut::along_handle ? tr("along the handle") : tr("across the handle");
  if (!showsSlice()) return name;
  for (const auto& target : scene_->targets)
    if (target.name == scene_->active_target) {
      const auto passing = scene::beamPassing(coil_->mri_T_coil, target.cortex_point);
      return cut_ == scene::CoilCut::along_handle
                 ? tr("along: cortex %1 mm below the scalp").arg(guidance::cortexDepth_mm(target), 0, 'f', 0)
                 : tr("across: beam %1 mm off").arg(passing.miss_mm, 0, 'f', 1);
    }
  return name;
}

QString CoilSliceView::boundWords() const {
  if (!showsSlice() || !coil_->bound95_mm || *coil_->bound95_mm <= 0) return {};
  return tr("ring: 95 % within %1 mm").arg(*coil_->bound95_mm, 0, 'f', 1);
}

void CoilSliceView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), themeColour(Colour::picture));
  painter.setPen(themeColour(Colour::picture_words));
  if (showsSlice()) {
    if (is_outdated_) picture_ = toQImage(coilSlicePicture(*scene_, *coil_, cut_, plane()));
    painter.drawImage(0, 0, picture_);
  } else {
    painter.drawText(rect().adjusted(8, 8, -8, -8), Qt::AlignCenter | Qt::TextWordWrap, words_);
  }
  is_outdated_ = false;
  const QFontMetrics metrics = painter.fontMetrics();
  QColor behind_words = themeColour(Colour::picture);
  behind_words.setAlpha(170);
  const auto write = [&](const QString& words, int top) {
    if (words.isEmpty()) return;
    const QString shown = longestFitting(words, metrics, width() - 16);
    if (showsSlice())  // grey words on grey tissue cannot be read
      painter.fillRect(4, top, metrics.horizontalAdvance(shown) + 8, metrics.height(), behind_words);
    painter.drawText(8, top + metrics.ascent(), shown);
  };
  const int letters = sized(24);  // the letters of the sides are drawn below
  write(caption(), 4);
  write(boundWords(), height() - letters - metrics.height());
  paintFocus(painter, *this);
}

ViewOffers CoilSliceView::offersAt(const QPoint& position) {
  ViewOffers offers;
  offers.reset = [this] { reset(); };
  if (!showsSlice()) return offers;
  offers.place = plane().toMri(position.x(), position.y());
  // Where nobody follows the crosshair (live slices), there is nowhere to go.
  if (isSignalConnected(QMetaMethod::fromSignal(&CoilSliceView::crosshairMoved)))
    offers.goTo = [this, mm = offers.place->mm] { emit crosshairMoved(mm.x(), mm.y(), mm.z()); };
  return offers;
}

void CoilSliceView::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::RightButton && (event->pos() - pressed_at_).manhattanLength() <= kClickReach_px)
    openViewMenu(*this, event->pos(), offersAt(event->pos()));
}

void CoilSliceView::contextMenuEvent(QContextMenuEvent* event) {
  if (event->reason() != QContextMenuEvent::Mouse)
    openViewMenu(*this, rect().center(), offersAt(rect().center()));
}

void CoilSliceView::mousePressEvent(QMouseEvent* event) {
  last_ = event->pos();
  pressed_at_ = event->pos();
  if (!showsSlice() || event->button() != Qt::LeftButton || event->modifiers() & Qt::ControlModifier) return;
  const auto p = plane().toMri(event->pos().x(), event->pos().y());
  emit crosshairMoved(p.mm.x(), p.mm.y(), p.mm.z());
}

void CoilSliceView::mouseMoveEvent(QMouseEvent* event) {
  if (!showsSlice()) return;
  const QPoint step = event->pos() - last_;
  last_ = event->pos();
  if (event->buttons() & Qt::LeftButton && event->modifiers() & Qt::ControlModifier) {
    dragWindow(*scene_, step);
    emit windowChanged();
  } else if (event->buttons() & Qt::LeftButton) {
    const auto p = plane().toMri(event->pos().x(), event->pos().y());
    emit crosshairMoved(p.mm.x(), p.mm.y(), p.mm.z());
  } else if (event->buttons() & Qt::RightButton &&
             (event->pos() - pressed_at_).manhattanLength() > kClickReach_px) {
    zoom_ = std::clamp(zoom_ * (1.0 - 0.01 * step.y()), 0.5, 8.0);
    refresh();
  }
}

void CoilSliceView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (!showsSlice()) return;
  const auto p = plane().toMri(event->pos().x(), event->pos().y());
  emit chosen(p.mm.x(), p.mm.y(), p.mm.z());
}

void CoilSliceView::resizeEvent(QResizeEvent*) { refresh(); }

}  // namespace facenav::ui
