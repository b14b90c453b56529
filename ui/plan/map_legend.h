#pragma once
// MapLegend: colours of the displayed maps with values and unit, for both signs.

#include <QWidget>

#include "plan/overlay_presenter.h"

namespace facenav::ui {

class MapLegend : public QWidget {
  Q_OBJECT

 public:
  explicit MapLegend(OverlayPresenter& presenter, QWidget* parent = nullptr);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void showMaps();

  OverlayPresenter& presenter_;
  std::vector<casefile::OverlayEntry> maps_;
};

}  // namespace facenav::ui
