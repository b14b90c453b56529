#pragma once
// ElidedLabel: one line of text that ends in an ellipsis if it does not fit; the tooltip has the whole text.
// A text of several parts leaves out whole parts instead.

#include <QLabel>

namespace facenav::ui {

class ElidedLabel : public QLabel {
 public:
  explicit ElidedLabel(QWidget* parent = nullptr);
  void set(const QString& words);
  /// Shows as many parts as fit: the second is left out first, then the next ones. The first one alone is
  /// shortened if a person wrote it (users_words.h), else left out, too.
  void setParts(const QStringList& parts);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fit();
  QStringList parts_;
};

}  // namespace facenav::ui
