#include "setup/marked_picture.h"

#include <QPainter>

#include "shell/image_view.h"
#include "shell/theme.h"

namespace facenav::ui {
namespace {

constexpr int kCells = 3;

/// Colour on a camera's picture: the dark theme's, since the picture does not change with the theme.
QColor onPicture(Colour colour, int alpha = 255) {
  QColor on = themeColour(colour, Theme::dark);
  on.setAlpha(alpha);
  return on;
}

/// Marks covered parts with a tick and a thin frame, so that the state is not in colour alone.
void drawCoverage(QPainter& painter, const QSize& size, const std::vector<bool>& cells) {
  const int w = size.width() / kCells, h = size.height() / kCells;
  const QColor grid = onPicture(Colour::picture_text, 70), covered = onPicture(Colour::good, 45);
  for (int i = 0; i < kCells * kCells; ++i) {
    const QRect cell((i % kCells) * w, (i / kCells) * h, w, h);
    painter.setPen(QPen(grid, 1));
    painter.drawRect(cell);
    if (!cells[std::size_t(i)]) continue;
    painter.fillRect(cell, covered);
    painter.setPen(onPicture(Colour::good));
    painter.drawText(cell.adjusted(6, 4, 0, 0), Qt::AlignLeft | Qt::AlignTop, QString::fromUtf8("\u2713"));
  }
}

}  // namespace

QImage markedPicture(const steps::SetupView& view, bool is_left) {
  if (!view.frame) return {};
  const cv::Mat& grey = is_left ? view.frame->left : view.frame->right;
  QImage image =
      toQImage(grey.data, grey.cols, grey.rows, int(grey.step)).convertToFormat(QImage::Format_RGB32);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  const double line = std::max(2.0, image.width() / 320.0);
  QFont font = painter.font();
  font.setPixelSize(image.height() / 16);
  painter.setFont(font);
  if (view.step == steps::SetupStep::calibrate && view.coverage && !view.is_done)
    drawCoverage(painter, image.size(), is_left ? view.coverage->left_cells : view.coverage->right_cells);
  painter.setPen(QPen(onPicture(view.is_done ? Colour::good : Colour::now), line));
  if (const auto& box = is_left ? view.left_box : view.right_box)
    painter.drawRect(QRect(box->x, box->y, box->width, box->height));
  const auto& marks = is_left ? view.left_marks : view.right_marks;
  for (const auto& mark : marks) painter.drawEllipse(QPointF(mark.x, mark.y), 2 * line, 2 * line);
  if (marks.size() == 4)  // the coil's marker
    for (std::size_t i = 0; i < 4; ++i)
      painter.drawLine(QPointF(marks[i].x, marks[i].y), QPointF(marks[(i + 1) % 4].x, marks[(i + 1) % 4].y));
  return image;
}

}  // namespace facenav::ui
