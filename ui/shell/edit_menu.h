#pragma once
// EditMenu: undo, redo, cut, copy, paste and delete of the text field that has the focus, else of the page in
// view. It shows the keys but does not own them: fields and pages have their own shortcuts.

#include <QObject>
#include <QPointer>
#include <functional>
#include <utility>

class QAction;
class QLineEdit;
class QMenu;

namespace facenav::ui {

/// What a page lets the Edit menu do now. An empty function: not possible.
struct PageEdits {
  struct Step {
    std::function<void()> act;
    QString words = {};  // "exclude 12 pulses"; empty: the menu's own word is enough
  };
  Step undo, redo, remove;
};

class EditMenu : public QObject {
  Q_OBJECT

 public:
  /// Fills `menu`. `page` is asked when the menu opens and when an action is chosen.
  EditMenu(QMenu& menu, std::function<PageEdits()> page);

 private:
  QAction* add(QMenu& menu, const QString& name, const QKeySequence& keys, std::function<void()> act);
  void noteFocus(QWidget* now);
  void showState();
  void undoOrRedo(bool is_undo);
  void remove();
  QLineEdit* field() const;

  std::function<PageEdits()> page_;
  QPointer<QWidget> focus_;  // the menu itself takes the focus when it is opened by a key
  QAction *undo_, *redo_, *cut_, *copy_, *paste_, *remove_, *all_;
};

}  // namespace facenav::ui
