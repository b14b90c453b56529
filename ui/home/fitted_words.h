#pragma once
// FittedWords: shows a sentence as large as its place allows, up to a wanted size. With doubled text or in a
// small window it gets smaller; it is never cut.

#include <QColor>
#include <QWidget>

namespace facenav::ui {

class FittedWords : public QWidget {
  Q_OBJECT

 public:
  /// `largest_pt`: size at normal text size.
  explicit FittedWords(double largest_pt, QWidget* parent = nullptr);
  void set(const QString& words, const QColor& colour);
  const QString& words() const { return words_; }
  /// False if the words do not fit in the smallest size.
  bool isWhole() const;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QFont fittedFont() const;
  bool fits(const QFont& shown) const;

  double largest_pt_;
  QString words_;
  QColor colour_;
};

}  // namespace facenav::ui
