#include "plan/target_list.h"

#include <QContextMenuEvent>
#include <QMenu>

namespace facenav::ui {

TargetList::TargetList(PlanPresenter& plan, QWidget* parent) : QListWidget(parent), plan_(plan) {
  setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
  setToolTip(tr("double click or F2: rename   right click: more"));
  setAccessibleName(tr("targets"));
  connect(this, &QListWidget::currentTextChanged, this, [this](const QString& name) {
    if (!is_filling_) plan_.setActive(name);
  });
  connect(this, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) {
    if (!is_filling_) plan_.renameActive(item->text());
  });
  connect(&plan_, &PlanPresenter::changed, this, &TargetList::showPlan);
  showPlan();
}

void TargetList::showPlan() {
  is_filling_ = true;
  clear();
  for (const auto& target : plan_.plan().targets) {
    auto* item = new QListWidgetItem(QString::fromStdString(target.name), this);
    if (!target.is_locked) item->setFlags(item->flags() | Qt::ItemIsEditable);
    if (target.is_locked) item->setToolTip(tr("locked"));
    if (item->text() == plan_.activeName()) setCurrentItem(item);
  }
  is_filling_ = false;
  filter(words_);
}

void TargetList::filter(const QString& words) {
  words_ = words.trimmed();
  for (int i = 0; i < count(); ++i) {
    const auto* target = steps::find(plan_.plan(), item(i)->text().toStdString());
    const bool has_words =
        item(i)->text().contains(words_, Qt::CaseInsensitive) ||
        (target && QString::fromStdString(target->note).contains(words_, Qt::CaseInsensitive));
    item(i)->setHidden(!has_words);
  }
}

QMenu* TargetList::menuOf(const QString& target) {
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  const auto* planned = steps::find(plan_.plan(), target.toStdString());
  const bool is_locked = planned && planned->is_locked;
  const auto add = [&](const QString& words, bool is_possible, auto action) {
    auto* made = menu->addAction(words);
    made->setEnabled(planned && is_possible);
    connect(made, &QAction::triggered, this, action);
    return made;
  };
  const auto chosen = [this, target](auto edit) {
    return [this, target, edit] {
      plan_.setActive(target);
      edit();
    };
  };
  add(tr("Make active"), target != plan_.activeName(), chosen([] {}));
  add(tr("Rename (F2)"), !is_locked, [this, target] { rename(target); });
  add(tr("Duplicate"), true, chosen([this] { plan_.duplicateActive(); }));
  add(tr("Mirror to the other side"), true, chosen([this] { plan_.mirrorActive(); }));
  auto* lock = add(tr("Lock"), true, chosen([this, is_locked] { plan_.lockActive(!is_locked); }));
  lock->setCheckable(true);
  lock->setChecked(is_locked);
  menu->addSeparator();
  add(tr("Delete (Del)"), !is_locked, [this, target] { remove(target); });
  return menu;
}

/// Opens the field for a new name in the list.
void TargetList::rename(const QString& target) {
  plan_.setActive(target);
  if (auto* active = currentItem(); active && active->text() == target) editItem(active);
}

/// Removes a target. Another one that is active stays so.
void TargetList::remove(const QString& target) {
  const QString active = plan_.activeName();
  plan_.setActive(target);
  plan_.removeActive();
  if (active != target) plan_.setActive(active);
}

void TargetList::contextMenuEvent(QContextMenuEvent* event) {
  const bool is_key = event->reason() == QContextMenuEvent::Keyboard;
  auto* item = is_key ? currentItem() : itemAt(event->pos());
  if (!item) return;
  const QPoint at = is_key ? viewport()->mapToGlobal(visualItemRect(item).center()) : event->globalPos();
  menuOf(item->text())->popup(at);
}

/// The right button opens the menu only; it does not make a target active.
void TargetList::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::RightButton) QListWidget::mousePressEvent(event);
}

}  // namespace facenav::ui
