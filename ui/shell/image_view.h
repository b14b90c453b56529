#pragma once
// ImageView: an image scaled to the widget, aspect kept (the camera views).

#include <QImage>
#include <QPointF>
#include <QWidget>

#include "facenav/core/rgb_image.h"

namespace facenav::ui {

QImage toQImage(const RgbImage& image);
/// Copies an 8-bit grey image, `stride` bytes a row.
QImage toQImage(const unsigned char* grey, int width_px, int height_px, int stride);

class ImageView : public QWidget {
  Q_OBJECT

 public:
  explicit ImageView(const QString& when_empty, QWidget* parent = nullptr);
  /// Shows an image. `why_empty` is shown if there is none; empty: the words of the constructor.
  void set(const QImage& image, const QString& why_empty = {});
  /// Text in place of an image; empty if there is one.
  QString words() const {
    return !image_.isNull() ? QString() : why_empty_.isEmpty() ? when_empty_ : why_empty_;
  }

 signals:
  /// A click on the image; (0, 0) is the centre of its top-left pixel.
  void clicked(const QPointF& px);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;

 private:
  /// Rectangle in which the image is drawn.
  QRect place() const;

  QImage image_;
  QString when_empty_, why_empty_;
};

}  // namespace facenav::ui
