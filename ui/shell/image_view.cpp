#include "shell/image_view.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>

#include "shell/theme.h"

namespace facenav::ui {

QImage toQImage(const RgbImage& image) {
  if (image.empty()) return {};
  return QImage(image.rgb.data(), image.width_px, image.height_px, image.width_px * 3, QImage::Format_RGB888)
      .copy();
}

QImage toQImage(const unsigned char* grey, int width_px, int height_px, int stride) {
  if (!grey) return {};
  return QImage(grey, width_px, height_px, stride, QImage::Format_Grayscale8).copy();
}

ImageView::ImageView(const QString& when_empty, QWidget* parent) : QWidget(parent), when_empty_(when_empty) {
  setMinimumSize(200, 150);
}

void ImageView::set(const QImage& image, const QString& why_empty) {
  image_ = image;
  why_empty_ = why_empty;
  update();
}

void ImageView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), themeColour(Colour::picture));
  if (image_.isNull()) {
    painter.setPen(themeColour(Colour::picture_words));
    painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap, words());
    return;
  }
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(place(), image_);
}

QRect ImageView::place() const {
  const QSize size = image_.size().scaled(rect().size(), Qt::KeepAspectRatio);
  return QRect(QPoint((width() - size.width()) / 2, (height() - size.height()) / 2), size);
}

void ImageView::mousePressEvent(QMouseEvent* event) {
  if (image_.isNull() || !place().contains(event->pos())) return;
  const QRect drawn = place();
  const QPointF at = QPointF(event->pos() - drawn.topLeft()) + QPointF(0.5, 0.5);
  const auto px = [](double along, int shown, int size) {
    return std::clamp(along * size / shown - 0.5, 0.0, size - 1.0);
  };
  emit clicked({px(at.x(), drawn.width(), image_.width()), px(at.y(), drawn.height(), image_.height())});
}

}  // namespace facenav::ui
