#pragma once
// FiguresPanel: the figures of the Treat workspace, legible from two metres: instruction, then across, depth,
// tilt and twist at 48 pt and more. When lost: dashes.

#include <QFrame>
#include <QGridLayout>
#include <QLabel>
#include <array>

#include "treat/read_out.h"

namespace facenav::ui {

class FiguresPanel : public QFrame {
  Q_OBJECT

 public:
  explicit FiguresPanel(QWidget* parent = nullptr);
  void set(const ReadOut& read_out);
  /// Sets the layout. Small: all four figures in one row, for a low window whose room another panel needs.
  /// Low: a lower banner with smaller letters.
  void setSmall(bool is_small, bool is_low);
  /// Height that the figures need in two rows, px.
  int neededHeight();
  /// The shown figures (for tests and screen readers): across, depth, tilt, twist.
  std::array<QString, 4> figures() const;
  QString instruction() const { return banner_->text(); }

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void place();
  void fitBanner();
  void setDoubtful(bool is_doubtful);

  QLabel* banner_;
  QGridLayout* grid_;
  QBoxLayout* below_;  // gap and predicted error; side by side where the figures are small
  std::array<QLabel*, 4> values_, names_;
  bool is_small_ = false, is_low_ = false;
  int needed_px_ = 0;
  ReadOut read_out_;
  QString fitted_;  // inputs for which the banner's letters were fitted
  void showSecond(const QString& words);

  QLabel *predicted_, *gap_, *second_ = nullptr;  // second_: made with the first words of a second coil
};

}  // namespace facenav::ui
