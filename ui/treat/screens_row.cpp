#include "treat/screens_row.h"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QPushButton>
#include <QSignalBlocker>

namespace facenav::ui {

ScreensRow::ScreensRow(SecondScreens& screens, ProjectorPresenter& projector, QWidget* parent)
    : QWidget(parent), screens_(screens), projector_(projector) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  const auto add = [&](const QString& words, const QKeySequence& key, const QString& tip) {
    auto* button = new QPushButton(words, this);
    button->setCheckable(true);
    button->setObjectName("tool");
    button->setToolTip(tip);
    button->setShortcut(key);
    row->addWidget(button, 1);
    return button;
  };
  guidance_ =
      add(tr("Second screen"), Qt::Key_F8,
          tr("guidance alone, to be read at three metres, on another screen where there is one (F8)"));
  projector_button_ =
      add(tr("Projector"), Qt::SHIFT + Qt::Key_F8,
          tr("outline, ring and arrow on the head, by a calibrated projector (projector.yml); it "
             "must show the window's picture unscaled (Shift+F8)"));
  connect(guidance_, &QPushButton::toggled, &screens_, &SecondScreens::showGuidance);
  connect(projector_button_, &QPushButton::toggled, this, &ScreensRow::toggleProjector);
  connect(&screens_, &SecondScreens::changed, this, &ScreensRow::showState);
}

void ScreensRow::toggleProjector(bool is_shown) {
  if (is_shown && !projector_.isOpen()) {
    QString file = projector_.knownFile();
    if (file.isEmpty())
      file = QFileDialog::getOpenFileName(this, tr("The projector's calibration"), {},
                                          tr("projector.yml (*.yml)"));
    if (!file.isEmpty()) projector_.open(file);
  }
  screens_.showProjector(is_shown);
  showState();
}

void ScreensRow::showState() {
  const QSignalBlocker first(guidance_), second(projector_button_);
  guidance_->setChecked(screens_.showsGuidance());
  projector_button_->setChecked(screens_.showsProjector());
}

}  // namespace facenav::ui
