#pragma once
// ShortcutList: all keyboard shortcuts of a window, read from its actions, buttons and shortcuts. A QShortcut
// says what it does in its whatsThis(); an action by its text, a button by its text and tooltip.

#include <QKeySequence>
#include <QString>
#include <utility>
#include <vector>

class QShortcut;
class QWidget;

namespace facenav::ui {

struct ShortcutLine {
  QString page;   // where it works; empty: everywhere in the window
  QString keys;   // "Ctrl+Z"; several with the same effect: "Return, Enter"
  QString words;  // what it does; empty if nothing in the window says it
};

/// The shortcuts in order of the pages, those that work everywhere first. `pages`: a page and its name.
std::vector<ShortcutLine> shortcutsOf(const QWidget& window,
                                      const std::vector<std::pair<const QWidget*, QString>>& pages);
/// The list as HTML, one table a page.
QString shortcutsAsHtml(const std::vector<ShortcutLine>& lines);

}  // namespace facenav::ui
