#include "plan/target_tools.h"

#include <QGuiApplication>
#include <QHBoxLayout>
#include <QMenu>
#include <QToolButton>
#include <QWidgetAction>

#include "plan/grid_panel.h"
#include "shell/help_window.h"
#include "shell/shown_words.h"

namespace facenav::ui {
namespace {

/// Shows a wait cursor: the first measures of a head and large grids take a second or two.
class WaitCursor {
 public:
  WaitCursor() { QGuiApplication::setOverrideCursor(Qt::WaitCursor); }
  ~WaitCursor() { QGuiApplication::restoreOverrideCursor(); }
  WaitCursor(const WaitCursor&) = delete;
  WaitCursor& operator=(const WaitCursor&) = delete;
};

}  // namespace

TargetTools::TargetTools(PlanPresenter& plan, HeadPresenter& head, QWidget* parent)
    : QFrame(parent), plan_(plan), head_(head) {
  HelpWindow::setPlace(*this, "plan.md", "change-targets");
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(4);
  row->addWidget(button(tr("Preset"),
                        tr("a target at a known place of either side: M1, DLPFC, Beam F3 and F4, EEG sites"),
                        presetMenu()));
  row->addWidget(button(tr("Grid"), tr("targets in rows and columns round the active one"), gridMenu()));
  row->addWidget(button(tr("More"), tr("copy, mirror, lock, order, compare"), moreMenu()));
  row->addWidget(
      button(tr("Head"), tr("nasion, inion and tragi, which EEG sites are measured from"), headMenu()));
  row->addStretch(1);
}

QToolButton* TargetTools::button(const QString& words, const QString& tip, QMenu* menu) {
  auto* made = new QToolButton(this);
  made->setText(words);
  made->setToolTip(tip);
  made->setMenu(menu);
  made->setPopupMode(QToolButton::InstantPopup);
  made->setObjectName("tool");
  return made;
}

void TargetTools::addPreset(const QString& name) {
  const WaitCursor waiting;
  if (const auto* measures = head_.measures()) plan_.addPreset(name, *measures);
}

QMenu* TargetTools::presetMenu() {
  auto* menu = new QMenu(this);
  auto* eeg = new QMenu(tr("EEG site"), menu);
  for (const auto& preset : steps::presets()) {
    const QString name = QString::fromStdString(preset.name);
    const bool is_eeg = name.startsWith("eeg:");
    auto* action = (is_eeg ? eeg : menu)->addAction(is_eeg ? name.mid(4) : shownWords(preset.words));
    action->setToolTip(shownWords(preset.source));
    connect(action, &QAction::triggered, this, [this, name] { addPreset(name); });
  }
  menu->addMenu(eeg);
  menu->setToolTipsVisible(true);
  return menu;
}

QMenu* TargetTools::gridMenu() {
  auto* menu = new QMenu(this);
  auto* panel = new GridPanel(plan_, menu);
  auto* action = new QWidgetAction(menu);
  action->setDefaultWidget(panel);
  menu->addAction(action);
  connect(panel, &GridPanel::done, menu, &QMenu::close);
  return menu;
}

QMenu* TargetTools::moreMenu() {
  auto* menu = new QMenu(this);
  auto* copy = menu->addAction(tr("Duplicate"), &plan_, &PlanPresenter::duplicateActive);
  auto* mirror = menu->addAction(tr("Mirror to the other side"), &plan_, &PlanPresenter::mirrorActive);
  auto* lock = menu->addAction(tr("Lock"));
  lock->setCheckable(true);
  connect(lock, &QAction::triggered, &plan_, &PlanPresenter::lockActive);
  menu->addSeparator();
  auto* up = menu->addAction(tr("Move up"), &plan_, [this] { plan_.moveActive(-1); });
  auto* down = menu->addAction(tr("Move down"), &plan_, [this] { plan_.moveActive(1); });
  auto* compare = menu->addMenu(tr("Compare with"));
  connect(compare, &QMenu::aboutToShow, this, [this, compare] { fillCompareMenu(compare); });
  const QList<QAction*> all{copy, mirror, lock, up, down, compare->menuAction()};
  connect(menu, &QMenu::aboutToShow, this, [this, lock, all] {
    for (auto* action : all) action->setEnabled(plan_.active() != nullptr);
    lock->setChecked(plan_.active() && plan_.active()->is_locked);
  });
  return menu;
}

void TargetTools::fillCompareMenu(QMenu* menu) {
  menu->clear();
  connect(menu->addAction(tr("none")), &QAction::triggered, this, [this] { emit compareWith({}); });
  for (const auto& target : plan_.plan().targets) {
    const QString name = QString::fromStdString(target.name);
    if (name == plan_.activeName()) continue;
    connect(menu->addAction(name), &QAction::triggered, this, [this, name] { emit compareWith(name); });
  }
}

QMenu* TargetTools::headMenu() {
  auto* menu = new QMenu(this);
  for (const auto which : surface::kLandmarks)
    connect(menu->addAction(tr("Set %1 at the crosshair").arg(landmarkWords(which))), &QAction::triggered,
            this, [this, which] { emit landmarkWanted(which); });
  auto* again = menu->addMenu(tr("Find again"));
  for (const auto which : surface::kLandmarks)
    connect(again->addAction(landmarkWords(which)), &QAction::triggered, this, [this, which] {
      const WaitCursor waiting;
      head_.findAgain(which);
    });
  auto* sites = menu->addMenu(tr("Crosshair to"));
  const auto addSite = [&](const QString& name) {
    connect(sites->addAction(name), &QAction::triggered, this, [this, name] {
      const WaitCursor waiting;
      if (const auto p = head_.site(name)) emit goTo(p->mm.x(), p->mm.y(), p->mm.z());
    });
  };
  for (const auto& name : guidance::eegSiteNames()) addSite(QString::fromStdString(name));
  addSite("Beam F3");
  addSite("Beam F4");
  menu->addSeparator();
  QList<QAction*> found;  // a line each, since a menu shows no line breaks
  for (std::size_t i = 0; i < surface::kLandmarks.size(); ++i) {
    found << menu->addAction(QString());
    found.last()->setEnabled(false);
  }
  connect(menu, &QMenu::aboutToShow, this, [this, found] {
    const WaitCursor waiting;
    const QStringList lines = head_.describe().split('\n');
    for (int i = 0; i < found.size(); ++i) found[i]->setText(lines.value(i));
  });
  return menu;
}

}  // namespace facenav::ui
