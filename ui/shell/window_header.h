#pragma once
// WindowHeader: the strip over every workspace: the program's name, the open case and, in Treat, the states
// of cameras, face and coil with the frame's timing. Where it is narrow, the timing goes first, then the
// name.

#include <QFrame>

#include "treat/read_out.h"

class QLabel;

namespace facenav::ui {

class ElidedLabel;
class StatusChip;

class WindowHeader : public QFrame {
  Q_OBJECT

 public:
  explicit WindowHeader(QWidget* parent = nullptr);
  /// The case first, then what is known of it; where it is narrow, the second part goes first.
  void setCaseWords(const QStringList& parts);
  void setLive(const ReadOut& read_out);
  /// The live states are shown in Treat only.
  void showLiveStates(bool are_shown);
  /// Room for the live states alone.
  QSize minimumSizeHint() const override;

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fit();

  ElidedLabel* case_words_;
  StatusChip *cameras_, *face_, *coil_;
  QLabel *name_, *timing_;
  bool are_live_ = true;
};

}  // namespace facenav::ui
