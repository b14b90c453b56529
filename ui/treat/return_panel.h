#pragma once
// ReturnPanel: shown over the Treat workspace while an interrupted session can be continued. One sentence and
// two choices; not modal.

#include <QFrame>

#include "treat/return_presenter.h"

class QLabel;
class QPushButton;

namespace facenav::ui {

class ReturnPanel : public QFrame {
  Q_OBJECT

 public:
  explicit ReturnPanel(ReturnPresenter& presenter, QWidget* parent = nullptr);

 private:
  void showState();

  ReturnPresenter& presenter_;
  QLabel* words_;
  QPushButton* go_on_;
};

}  // namespace facenav::ui
