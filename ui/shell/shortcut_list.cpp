#include "shell/shortcut_list.h"

#include <QAbstractButton>
#include <QAction>
#include <QObject>
#include <QRegularExpression>
#include <QShortcut>
#include <QWidget>
#include <algorithm>

namespace facenav::ui {
namespace {

using Pages = std::vector<std::pair<const QWidget*, QString>>;

/// Text of a button or an action without mnemonic, symbols on a line of their own, and ellipsis.
QString plainText(QString text) {
  text = text.section('\n', -1).section('\t', 0, 0);
  text.replace("&&", QChar(0x1)).remove('&').replace(QChar(0x1), '&');
  return text.remove(QChar(0x2026)).simplified();
}

/// Tooltip without the key in brackets at its end.
QString withoutKey(const QString& tooltip) {
  static const QRegularExpression kKey("\\s*\\([^()]*\\)$");
  return QString(tooltip).remove(kKey).simplified();
}

QString buttonWords(const QAbstractButton& button) {
  const QString text = plainText(button.text()), tip = withoutKey(button.toolTip());
  if (tip.isEmpty() || tip.startsWith(text, Qt::CaseInsensitive)) return tip.isEmpty() ? text : tip;
  return text.isEmpty() ? tip : text + ": " + tip;
}

/// Words of a shortcut that does not describe itself: those of the control on its page that names its key.
QString wordsNearby(const QShortcut& shortcut, const QString& keys) {
  const auto* page = qobject_cast<const QWidget*>(shortcut.parent());
  if (!page) return {};
  for (const auto* button : page->findChildren<QAbstractButton*>()) {
    const QString tip = button->toolTip();
    if (tip == keys) return plainText(button->text());
    if (tip.endsWith("(" + keys + ")")) return buttonWords(*button);
  }
  return {};
}

int pageOf(const QObject* object, const Pages& pages) {
  for (; object; object = object->parent())
    for (std::size_t i = 0; i < pages.size(); ++i)
      if (object == pages[i].first) return int(i);
  return -1;
}

/// True for a menu's action, and for what lies in the window itself, not in a dialog over it.
bool isPartOf(const QWidget& window, const QObject* object) {
  if (qobject_cast<const QAction*>(object)) return true;
  while (object && !object->isWidgetType()) object = object->parent();
  return object && static_cast<const QWidget*>(object)->window() == &window;
}

class Collector {
 public:
  Collector(const QWidget& window, const Pages& pages)
      : window_(window), pages_(pages), by_page_(pages.size() + 1) {}

  void add(const QObject& owner, const QKeySequence& keys, const QString& words) {
    const int page = pageOf(&owner, pages_);
    if (keys.isEmpty() || (page < 0 && !isPartOf(window_, &owner))) return;
    const QString name = page < 0 ? QString() : pages_[std::size_t(page)].second;
    const QString text = keys.toString(QKeySequence::NativeText);
    auto& lines = by_page_[std::size_t(page + 1)];
    for (auto& line : lines) {
      if (line.words != words || words.isEmpty()) continue;
      if (!line.keys.split(", ").contains(text)) line.keys += ", " + text;
      return;
    }
    lines.push_back({name, text, words});
  }
  std::vector<ShortcutLine> lines() const {
    std::vector<ShortcutLine> all;
    for (const auto& lines : by_page_) all.insert(all.end(), lines.begin(), lines.end());
    return all;
  }

 private:
  const QWidget& window_;
  const Pages& pages_;
  std::vector<std::vector<ShortcutLine>> by_page_;
};

}  // namespace

std::vector<ShortcutLine> shortcutsOf(const QWidget& window, const Pages& pages) {
  Collector collector(window, pages);
  for (const auto* action : window.findChildren<QAction*>())
    for (const auto& keys : action->shortcuts()) collector.add(*action, keys, plainText(action->text()));
  for (const auto* button : window.findChildren<QAbstractButton*>())
    collector.add(*button, button->shortcut(), buttonWords(*button));
  for (const auto* shortcut : window.findChildren<QShortcut*>()) {
    const QString keys = shortcut->key().toString(QKeySequence::NativeText);
    const QString said = shortcut->whatsThis();
    collector.add(*shortcut, shortcut->key(), said.isEmpty() ? wordsNearby(*shortcut, keys) : said);
  }
  return collector.lines();
}

QString shortcutsAsHtml(const std::vector<ShortcutLine>& lines) {
  QString html = "<h1>" + QObject::tr("Keyboard shortcuts") + "</h1>";
  const QString* page = nullptr;
  for (const auto& line : lines) {
    if (!page || *page != line.page) {
      if (page) html += "</table>";
      const QString name = line.page.isEmpty() ? QObject::tr("Everywhere") : line.page;
      html += "<h2>" + name.toHtmlEscaped() + "</h2><table cellpadding='3'>";
    }
    page = &line.page;
    const QString words = line.words.isEmpty() ? QObject::tr("see the tooltips of this page") : line.words;
    html +=
        "<tr><td><b>" + line.keys.toHtmlEscaped() + "</b></td><td>" + words.toHtmlEscaped() + "</td></tr>";
  }
  return page ? html + "</table>" : html;
}

}  // namespace facenav::ui
