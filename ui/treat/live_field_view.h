#pragma once
// LiveFieldView: the live electric field in words under the 3-D scene of Treat, with the colour bar.

#include <QFrame>

#include "treat/live_field_presenter.h"

class QLabel;

namespace facenav::ui {

class ColourLegend;

class LiveFieldView : public QFrame {
  Q_OBJECT

 public:
  explicit LiveFieldView(LiveFieldPresenter& presenter, QWidget* parent = nullptr);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fitHeight();
  void showField();

  LiveFieldPresenter& presenter_;
  ColourLegend* bar_;
  QLabel* words_;
};

}  // namespace facenav::ui
