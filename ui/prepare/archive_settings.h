#pragma once
// ArchiveSettings: the connection to the archive: names, ports, TLS, retrieval; with a test.

#include <QFrame>

#include "prepare/archive_presenter.h"

class QComboBox;
class QFormLayout;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace facenav::ui {

class ArchiveSettings : public QFrame {
  Q_OBJECT

 public:
  explicit ArchiveSettings(ArchivePresenter& presenter, QWidget* parent = nullptr);

 private:
  QLineEdit* line(QFormLayout& form, const QString& name, const std::string& value, const QString& tip);
  QSpinBox* number(QFormLayout& form, const QString& name, int value, int most, const QString& tip);
  void take();

  ArchivePresenter& presenter_;
  QLineEdit *host_, *title_, *own_title_, *trusted_, *certificate_, *key_;
  QSpinBox *port_, *own_port_, *timeout_;
  QComboBox* retrieval_;
  QPushButton* test_;
};

}  // namespace facenav::ui
