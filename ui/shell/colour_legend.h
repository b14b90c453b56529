#pragma once
// ColourLegend: the scale of sequentialColour with its ends, name and unit.

#include <QWidget>
#include <optional>

#include "facenav/scene/colour_scale.h"

namespace facenav::ui {

class ColourLegend : public QWidget {
  Q_OBJECT

 public:
  explicit ColourLegend(QWidget* parent = nullptr);
  /// Sets the scale; without a range only `words` are shown.
  void set(const QString& words, const QString& unit, int decimals, std::optional<scene::ColourRange> range);
  /// "error 0.2 to 4.1 mm".
  QString words() const;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString words_, unit_;
  int decimals_ = 1;
  std::optional<scene::ColourRange> range_;
};

}  // namespace facenav::ui
