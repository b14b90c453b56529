#include "shell/shown_tools.h"

#include <QHBoxLayout>
#include <QMenu>
#include <QPushButton>
#include <QSettings>
#include <QToolButton>
#include <QWidgetAction>

#include "plan/dose_panel.h"
#include "plan/field_panel.h"
#include "plan/overlays_panel.h"
#include "shell/help_window.h"
#include "shell/words_of_button.h"

namespace facenav::ui {

ShownTools::ShownTools(PlanPresenter& plan, OverlayPresenter& overlays, FieldPresenter& field,
                       QWidget* parent)
    : QFrame(parent), row_(new QHBoxLayout(this)) {
  row_->setContentsMargins(0, 0, 0, 0);
  row_->setSpacing(2);  // five buttons fit into a window of 1280
  addMenu(tr("Overlays"), tr("maps, masks, tracts and surfaces of other programs over the MRI"),
          new OverlaysPanel(overlays), {"plan.md", "maps-masks-and-tracts-over-the-mri"});
  addMenu(tr("Field"), tr("the electric field that the planned coil induces in the brain"),
          new FieldPanel(field), {"field.md", "in-the-window"});
  addMenu(tr("Dose"), tr("protocol, pulses of the target, and the coil"), new DosePanel(plan),
          {"plan.md", "the-coil-and-the-protocol"});
  slices_ = addSwitch(tr("Coil"),
                      tr("the MRI along the axis of the target's coil, along and across its handle (M)"),
                      "plan/coil_slices_shown", true);
  slices_->setShortcut(Qt::Key_M);
  sites_ =
      addSwitch(tr("EEG"), tr("the sites of the 10-20 system on the scalp"), "plan/eeg_sites_shown", false);
  connect(slices_, &QPushButton::toggled, this, &ShownTools::coilSlicesShown);
  connect(sites_, &QPushButton::toggled, this, &ShownTools::sitesShown);
  row_->addStretch(1);
}

bool ShownTools::showsCoilSlices() const { return slices_->isChecked(); }
bool ShownTools::showsSites() const { return sites_->isChecked(); }

template <class Chooser>
void ShownTools::addMenu(const QString& words, const QString& tip, Chooser* panel,
                         const std::pair<QString, QString>& help) {
  auto* menu = new QMenu(this);
  auto* action = new QWidgetAction(menu);
  action->setDefaultWidget(panel);
  menu->addAction(action);
  connect(panel, &Chooser::choosing, menu, &QMenu::close);
  auto* button = new QToolButton(this);
  button->setText(words);
  button->setToolTip(tip);
  button->setMenu(menu);
  button->setPopupMode(QToolButton::InstantPopup);
  button->setObjectName("tool");
  HelpWindow::setPlace(*button, help.first, help.second);
  row_->addWidget(button);
}

/// Adds a button that stays down.
QPushButton* ShownTools::addSwitch(const QString& words, const QString& tip, const char* setting,
                                   bool is_on_at_first) {
  auto* button = new QPushButton(words, this);
  button->setObjectName("tool");
  button->setCheckable(true);
  button->setToolTip(tip);
  leaveRoomForBold(*button);
  button->setChecked(QSettings().value(setting, is_on_at_first).toBool());
  connect(button, &QPushButton::toggled, this,
          [setting](bool is_on) { QSettings().setValue(setting, is_on); });
  row_->addWidget(button);
  return button;
}

}  // namespace facenav::ui
