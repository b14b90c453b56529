#pragma once
// Step 2, Series: the series of a folder, each with a small image; the chosen one is queued.

#include <QWidget>

#include "prepare/prepare_presenter.h"

class QListWidget;
class QPushButton;

namespace facenav::ui {

class ElidedLabel;

class SeriesPage : public QWidget {
  Q_OBJECT

 public:
  explicit SeriesPage(PreparePresenter& presenter, QWidget* parent = nullptr);
  /// Asks for a folder to read.
  void chooseFolder();

 signals:
  void queued();
  void archiveWanted();

 private:
  void chooseFile();
  void showLines();
  void queueChosen();

  PreparePresenter& presenter_;
  QListWidget* series_;
  ElidedLabel* input_;
  QPushButton* prepare_;
};

}  // namespace facenav::ui
