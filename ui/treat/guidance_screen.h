#pragma once
// GuidanceScreen: guidance alone, for a second screen on the patient's side: one glyph (shape), one word, the
// figure of the step to take, the distance, and what to do in words. Legible at three metres: the smallest
// letters are 7 % of the window's height, which is 0.3 degrees on a screen of 24 inches. The arrow points as
// on the bull's eye: seen along the coil into the head, handle below.

#include <QWidget>

#include "facenav/guidance/guidance.h"
#include "treat/read_out.h"

namespace facenav::ui {

class GuidanceScreen : public QWidget {
  Q_OBJECT

 public:
  explicit GuidanceScreen(QWidget* parent);
  void set(const guidance::GuidanceState& guidance, const ReadOut& read_out);

  /// The drawn texts, for tests and screen readers: "MOVE", "3.4 mm", "12.0 mm away".
  QString word() const { return word_; }
  QString figure() const { return figure_; }
  QString distance() const { return distance_; }
  /// Direction of the arrow on the screen, radians from right, counter-clockwise; nothing without an arrow.
  std::optional<double> arrow_rad() const { return arrow_rad_; }
  static constexpr double kLeastLetters = 0.07;  // share of the window's height

 signals:
  void closed();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void drawGlyph(QPainter& painter, const QRectF& square) const;
  void drawWords(QPainter& painter, const QRectF& room) const;

  ReadOut read_out_;
  guidance::Action action_ = guidance::Action::none;
  QString word_, figure_, distance_;
  std::optional<double> arrow_rad_;
  bool tilts_left_up_ = false, tilts_handle_ = false;
  double turn_rad_ = 0;  // > 0: the handle must turn clockwise, seen along the coil
};

}  // namespace facenav::ui
