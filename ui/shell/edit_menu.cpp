#include "shell/edit_menu.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>

namespace facenav::ui {
namespace {

/// "Undo: exclude 12 pulses", followed by the key, which the menu shows on the right.
QString labelOf(const QAction& action, const PageEdits::Step* step) {
  const QStringList parts = action.data().toStringList();
  const bool has_words = step && !step->words.isEmpty();
  return (has_words ? parts[0] + ": " + QString(step->words).replace("&", "&&") : parts[0]) + "\t" + parts[1];
}

bool hasText(const QLineEdit& field) { return field.isEnabled() && !field.isReadOnly(); }

}  // namespace

EditMenu::EditMenu(QMenu& menu, std::function<PageEdits()> page) : QObject(&menu), page_(std::move(page)) {
  undo_ = add(menu, tr("&Undo"), QKeySequence::Undo, [this] { undoOrRedo(true); });
  redo_ = add(menu, tr("&Redo"), QKeySequence::Redo, [this] { undoOrRedo(false); });
  menu.addSeparator();
  cut_ = add(menu, tr("Cu&t"), QKeySequence::Cut, [this] {
    if (auto* line = field()) line->cut();
  });
  copy_ = add(menu, tr("&Copy"), QKeySequence::Copy, [this] {
    if (auto* line = field()) line->copy();
  });
  paste_ = add(menu, tr("&Paste"), QKeySequence::Paste, [this] {
    if (auto* line = field()) line->paste();
  });
  remove_ = add(menu, tr("&Delete"), QKeySequence::Delete, [this] { remove(); });
  menu.addSeparator();
  all_ = add(menu, tr("Select &all"), QKeySequence::SelectAll, [this] {
    if (auto* line = field()) line->selectAll();
  });
  connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) { noteFocus(now); });
  connect(&menu, &QMenu::aboutToShow, this, &EditMenu::showState);
  noteFocus(QApplication::focusWidget());
}

QAction* EditMenu::add(QMenu& menu, const QString& name, const QKeySequence& keys,
                       std::function<void()> act) {
  auto* action = menu.addAction(name);
  action->setData(QStringList{name, keys.toString(QKeySequence::NativeText)});
  action->setText(labelOf(*action, nullptr));
  connect(action, &QAction::triggered, this, std::move(act));
  return action;
}

void EditMenu::noteFocus(QWidget* now) {
  const auto* window = qobject_cast<QWidget*>(parent()->parent());
  if (!now || qobject_cast<QMenu*>(now) || qobject_cast<QMenuBar*>(now)) return;
  if (!window || now->window() == window->window()) focus_ = now;
}

/// The text field that has the focus: a line, or that of a spin box or list.
QLineEdit* EditMenu::field() const {
  if (!focus_ || !focus_->isVisible()) return nullptr;
  if (auto* line = qobject_cast<QLineEdit*>(focus_)) return line;
  const bool has_line = focus_->inherits("QAbstractSpinBox") || focus_->inherits("QComboBox");
  return has_line ? focus_->findChild<QLineEdit*>() : nullptr;
}

void EditMenu::showState() {
  const PageEdits page = page_();
  const QLineEdit* line = field();
  const bool has_line = line && hasText(*line), has_selection = line && line->hasSelectedText();
  const bool undoes_text = has_line && line->isUndoAvailable(),
             redoes_text = has_line && line->isRedoAvailable();
  undo_->setEnabled(undoes_text || page.undo.act);
  redo_->setEnabled(redoes_text || page.redo.act);
  cut_->setEnabled(has_line && has_selection);
  copy_->setEnabled(has_selection);
  paste_->setEnabled(has_line && !QApplication::clipboard()->text().isEmpty());
  remove_->setEnabled((has_line && has_selection) || (!has_line && page.remove.act));
  all_->setEnabled(line && !line->text().isEmpty());
  undo_->setText(labelOf(*undo_, undoes_text ? nullptr : &page.undo));
  redo_->setText(labelOf(*redo_, redoes_text ? nullptr : &page.redo));
  remove_->setText(labelOf(*remove_, has_line ? nullptr : &page.remove));
}

void EditMenu::undoOrRedo(bool is_undo) {
  auto* line = field();
  const bool has_line = line && hasText(*line);
  if (has_line && (is_undo ? line->isUndoAvailable() : line->isRedoAvailable()))
    return is_undo ? line->undo() : line->redo();
  const PageEdits page = page_();
  if (const auto& act = is_undo ? page.undo.act : page.redo.act) act();
}

void EditMenu::remove() {
  auto* line = field();
  if (line && hasText(*line)) return line->del();
  if (const auto page = page_(); page.remove.act) page.remove.act();
}

}  // namespace facenav::ui
