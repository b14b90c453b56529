#pragma once
// Queries the archive and lists what it found, with the settings of the connection. The chosen series is
// fetched and queued.

#include <QWidget>

#include "prepare/archive_presenter.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace facenav::ui {

class ArchivePage : public QWidget {
  Q_OBJECT

 public:
  explicit ArchivePage(ArchivePresenter& presenter, QWidget* parent = nullptr);

 signals:
  /// The page is left: a series was queued, or the user went back.
  void queued();
  void left();

 private:
  QWidget* makeQuery();
  QWidget* makeFoot();
  void find();
  void showFound();
  void showState();

  ArchivePresenter& presenter_;
  QLineEdit *patient_id_, *patient_name_, *date_;
  QComboBox* modality_;
  QCheckBox* shows_patient_;
  QTableWidget* table_;
  QPushButton *find_, *fetch_, *cancel_;
  QLabel* words_;
};

}  // namespace facenav::ui
