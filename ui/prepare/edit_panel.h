#pragma once
// EditPanel: the tools for correcting the brain mask, with their keys.

#include <QFrame>

#include "prepare/edit_presenter.h"

class QButtonGroup;
class QCheckBox;
class QGridLayout;
class QLabel;
class QPushButton;
class QSlider;

namespace facenav::ui {

class EditPanel : public QFrame {
  Q_OBJECT

 public:
  explicit EditPanel(EditPresenter& presenter, QWidget* parent = nullptr);

 signals:
  void automaticShown(bool is_shown);

 private:
  void addTools(QGridLayout& grid);
  void addActions(QGridLayout& grid, int row);
  QPushButton* button(const QString& text, const QString& tip, const QKeySequence& key);
  void showState();
  bool cuts() const;

  EditPresenter& presenter_;
  QButtonGroup* tools_;
  QSlider* size_;
  QLabel *size_words_, *words_;
  QCheckBox* ball_;
  QPushButton *undo_, *redo_, *save_, *discard_;
};

}  // namespace facenav::ui
