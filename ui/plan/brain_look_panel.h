#pragma once
// BrainLookPanel: controls below a 3-D view: phi-theta model, cortex or distance; the slider of the peel
// depth; the colour map's scale and figures.

#include <QFrame>

#include "plan/cortex_presenter.h"

class QButtonGroup;
class QLabel;
class QSlider;

namespace facenav::ui {

class DistanceLegend;

class BrainLookPanel : public QFrame {
  Q_OBJECT

 public:
  explicit BrainLookPanel(CortexPresenter& presenter, QWidget* parent = nullptr);

 private:
  void showState();

  CortexPresenter& presenter_;
  QButtonGroup* looks_;
  QSlider* peel_;
  QLabel *peel_words_, *words_;
  DistanceLegend* legend_;
};

}  // namespace facenav::ui
