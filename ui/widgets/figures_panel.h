#pragma once
// FiguresPanel: the figures of the Treat workspace, legible from two metres: instruction, then across, depth,
// tilt and twist at 48 pt and more. When lost: dashes.

#include <QFrame>
#include <QGridLayout>
#include <QLabel>
#include <array>

#include "presenters/read_out.h"

namespace facenav::ui {

class FiguresPanel : public QFrame {
  Q_OBJECT

 public:
  explicit FiguresPanel(QWidget* parent = nullptr);
  void set(const ReadOut& read_out);
  /// Small: all four figures in one row, for a low window where another panel needs the room.
  void setSmall(bool is_small);
  /// The shown figures (for tests and screen readers): across, depth, tilt, twist.
  std::array<QString, 4> figures() const;
  QString instruction() const { return banner_->text(); }

 private:
  void place();

  QLabel* banner_;
  QGridLayout* grid_;
  std::array<QLabel*, 4> values_, names_;
  bool is_small_ = false;
  QLabel* predicted_;
};

}  // namespace facenav::ui
