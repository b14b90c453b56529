#include "support/window_checks.h"

#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QCheckBox>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QPushButton>
#include <QRadioButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSplitter>
#include <QStyle>
#include <QStyleOption>
#include <QTabBar>
#include <QTextBoundaryFinder>
#include <QTextDocument>
#include <QToolButton>
#include <algorithm>

#include "home/fitted_words.h"
#include "shell/elided_label.h"
#include "shell/status_chip.h"
#include "shell/users_words.h"

namespace facenav::testing {
namespace {

constexpr int kWords = 50;       // letters of a text that a fault quotes
constexpr int kEdge_px = 3;      // border of a button and its distance from the text
constexpr int kRounding_px = 1;  // of sizes in text units
constexpr int kStill_px = 3;     // a button that moves less stays under the mouse

/// True for parts that Qt lays out inside a widget of its own: viewports, bars, the line of a spin box.
bool isQtsOwn(const QWidget& widget) {
  if (widget.objectName().startsWith("qt_")) return true;
  for (const auto* parent = widget.parentWidget(); parent; parent = parent->parentWidget())
    if (qobject_cast<const QAbstractItemView*>(parent) || qobject_cast<const QAbstractSpinBox*>(parent) ||
        qobject_cast<const QComboBox*>(parent) || qobject_cast<const QTabBar*>(parent) ||
        qobject_cast<const QLineEdit*>(parent) || qobject_cast<const QMenuBar*>(parent) ||
        qobject_cast<const QScrollBar*>(parent))
      return true;
  return qobject_cast<const QSplitterHandle*>(&widget) || qobject_cast<const QScrollBar*>(&widget);
}

template <class Widget>
std::vector<const Widget*> visible(const QWidget& window) {
  std::vector<const Widget*> found;
  for (const auto* widget : window.findChildren<Widget*>())
    if (widget->isVisible() && widget->window() == &window && !isQtsOwn(*widget)) found.push_back(widget);
  return found;
}

QString nameOf(const QWidget& widget, const QString& words) {
  const QString kind = QString(widget.metaObject()->className()).remove("facenav::ui::");
  const QString name = widget.objectName().isEmpty() ? widget.accessibleName() : widget.objectName();
  const QString shown = words.simplified().left(kWords);
  return kind + (name.isEmpty() ? QString() : " #" + name) +
         (shown.isEmpty() ? QString() : " '" + shown + "'");
}

QString cut(const QWidget& widget, const QString& words, const QSize& needed, const QSize& room) {
  return QString("%1 is cut: it needs %2 x %3 px and has %4 x %5")
      .arg(nameOf(widget, words))
      .arg(needed.width())
      .arg(needed.height())
      .arg(room.width())
      .arg(room.height());
}

bool fits(const QSize& needed, const QSize& room) {
  return needed.width() <= room.width() + kRounding_px && needed.height() <= room.height() + kRounding_px;
}

/// True if the text may be shortened: a person's own words, whole in the tool tip.
bool mayBeShort(const QWidget& widget, const QString& text) {
  return ui::holdsUsersWords(widget) && widget.toolTip().contains(text);
}

/// Width of the longest part without a place to wrap: a word, or a few letters of Japanese.
int longestWord_px(const QLabel& label) {
  int longest_px = 0;
  const bool is_plain = label.textFormat() == Qt::PlainText ||
                        (label.textFormat() == Qt::AutoText && !Qt::mightBeRichText(label.text()));
  if (!is_plain) return 0;
  for (const QString& word : label.text().simplified().split(' ')) {
    QTextBoundaryFinder places(QTextBoundaryFinder::Line, word);
    for (int from = 0, to = places.toNextBoundary(); to >= 0; from = to, to = places.toNextBoundary())
      longest_px = std::max(longest_px, label.fontMetrics().horizontalAdvance(word.mid(from, to - from)));
  }
  return longest_px;
}

QString faultOf(const QLabel& label) {
  const QString text = label.text();
  if (text.isEmpty()) return {};
  if (dynamic_cast<const ui::ElidedLabel*>(&label)) {
    const QSize needed(label.fontMetrics().horizontalAdvance(text), label.fontMetrics().height());
    return fits(needed, label.size()) || mayBeShort(label, text) ? QString()
                                                                 : cut(label, text, needed, label.size());
  }
  if (!label.wordWrap())
    return fits(label.sizeHint(), label.size()) ? QString()
                                                : cut(label, text, label.sizeHint(), label.size());
  const QSize needed(longestWord_px(label) + label.width() - label.contentsRect().width(),
                     label.heightForWidth(label.width()));
  return fits(needed, label.size()) ? QString() : cut(label, text, needed, label.size());
}

/// Room of a button's text. The style sheet's padding may be used up: the text is drawn over it.
QSize roomOf(const QAbstractButton& button) {
  QStyleOptionButton option;
  option.initFrom(&button);
  if (qobject_cast<const QCheckBox*>(&button))
    return button.style()->subElementRect(QStyle::SE_CheckBoxContents, &option, &button).size();
  if (qobject_cast<const QRadioButton*>(&button))
    return button.style()->subElementRect(QStyle::SE_RadioButtonContents, &option, &button).size();
  return button.size() - QSize(2 * kEdge_px, 0);
}

QString faultOf(const QAbstractButton& button) {
  if (button.text().isEmpty()) return {};
  QFont font = button.font();  // without the style sheet's weight of an enabled button
  if (button.objectName() == "primary" && button.isEnabled()) font.setWeight(QFont::DemiBold);
  QSize needed = QFontMetrics(font).size(Qt::TextShowMnemonic, button.text());
  if (!button.icon().isNull()) needed.rwidth() += button.iconSize().width() + 2 * kEdge_px;
  return fits(needed, roomOf(button)) ? QString() : cut(button, button.text(), needed, roomOf(button));
}

QStringList faultsOf(const QTabBar& tabs) {
  QStringList faults;
  for (int i = 0; i < tabs.count(); ++i) {
    const QSize needed = tabs.fontMetrics().size(Qt::TextShowMnemonic, tabs.tabText(i));
    const QRect seen = tabs.tabRect(i) & tabs.rect();
    const QSize room = seen.size() - QSize(2 * kEdge_px, 0);
    if (!fits(needed, room)) faults << cut(tabs, tabs.tabText(i), needed, room);
  }
  return faults;
}

QString faultOf(const QComboBox& box) {
  QStyleOptionComboBox option;
  option.initFrom(&box);
  option.editable = box.isEditable();
  const QSize room =
      box.style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &box).size();
  QSize needed = box.fontMetrics().size(0, box.currentText());
  needed.setHeight(std::min(needed.height(), room.height()));
  if (!box.itemIcon(box.currentIndex()).isNull()) needed.rwidth() += box.iconSize().width() + 2 * kEdge_px;
  const bool is_whole = fits(needed, room) || mayBeShort(box, box.currentText());
  return is_whole ? QString() : cut(box, box.currentText(), needed, room);
}

/// Judges the hint in an empty field; what a person types may be longer than the field.
QString faultOf(const QLineEdit& field) {
  if (!field.text().isEmpty() || field.placeholderText().isEmpty()) return {};
  QStyleOptionFrame option;
  option.initFrom(&field);
  option.lineWidth = field.style()->pixelMetric(QStyle::PM_DefaultFrameWidth, &option, &field);
  const QSize room = field.style()->subElementRect(QStyle::SE_LineEditContents, &option, &field).size();
  const QSize needed(field.fontMetrics().horizontalAdvance(field.placeholderText()), 0);
  return fits(needed, room) ? QString() : cut(field, field.placeholderText(), needed, room);
}

QStringList faultsOf(const QHeaderView& header) {
  QStringList faults;
  QFont font = header.font();
  font.setWeight(QFont::DemiBold);  // the style sheet's
  const int margin_px = header.style()->pixelMetric(QStyle::PM_HeaderMargin, nullptr, &header);
  for (int i = 0; i < header.count(); ++i) {
    const QString words = header.model()->headerData(i, header.orientation()).toString();
    if (header.isSectionHidden(i) || words.isEmpty()) continue;
    QSize needed = QFontMetrics(font).size(0, words) + QSize(2 * margin_px, 0);  // of one or more lines
    if (header.isSortIndicatorShown() && header.sortIndicatorSection() == i)
      needed.rwidth() += header.style()->pixelMetric(QStyle::PM_HeaderMarkSize, nullptr, &header);
    const QSize room(header.sectionSize(i), header.height());
    if (!fits(needed, room)) faults << cut(header, words, needed, room);
  }
  return faults;
}

/// "A lies .. B": a fault of place.
QString placed(const QWidget& widget, const QString& how, const QWidget& other) {
  const auto* button = qobject_cast<const QAbstractButton*>(&widget);
  const auto* label = qobject_cast<const QLabel*>(&widget);
  const QRect at = widget.geometry();
  return QString("%1 at %2,%3 %4 x %5 %6 %7 of %8 x %9")
      .arg(nameOf(widget, button  ? button->text()
                          : label ? label->text()
                                  : QString()))
      .arg(at.x())
      .arg(at.y())
      .arg(at.width())
      .arg(at.height())
      .arg(how, nameOf(other, {}))
      .arg(other.width())
      .arg(other.height());
}

/// The scroll area whose content this is; null if it is none.
const QScrollArea* areaOf(const QWidget& content) {
  const auto* area =
      content.parentWidget() ? qobject_cast<QScrollArea*>(content.parentWidget()->parentWidget()) : nullptr;
  return area && area->widget() == &content ? area : nullptr;
}

QString outside(const QWidget& widget) {
  const QWidget& around = *widget.parentWidget();
  if (const auto* area = areaOf(widget)) {
    const bool is_wide =
        widget.width() > area->viewport()->width() && area->horizontalScrollBar()->maximum() == 0;
    const bool is_tall =
        widget.height() > area->viewport()->height() && area->verticalScrollBar()->maximum() == 0;
    const bool has_no_bar = widget.width() > area->viewport()->width() &&
                            area->horizontalScrollBarPolicy() == Qt::ScrollBarAlwaysOff;
    return is_wide || is_tall || has_no_bar ? placed(widget, "cannot be scrolled inside", *area) : QString();
  }
  return around.rect().contains(widget.geometry()) ? QString() : placed(widget, "lies outside", around);
}

}  // namespace

QStringList cutTexts(const QWidget& window) {
  QStringList faults;
  for (const auto* each : visible<QLabel>(window)) faults << faultOf(*each);
  for (const auto* each : visible<QAbstractButton>(window)) faults << faultOf(*each);
  for (const auto* each : visible<QTabBar>(window)) faults << faultsOf(*each);
  for (const auto* each : visible<QComboBox>(window)) faults << faultOf(*each);
  for (const auto* each : visible<QLineEdit>(window)) faults << faultOf(*each);
  for (const auto* each : window.findChildren<QHeaderView*>())
    if (each->isVisible() && each->window() == &window) faults << faultsOf(*each);
  for (const auto* each : visible<QWidget>(window))
    if (dynamic_cast<const ui::StatusChip*>(each) && !fits(each->sizeHint(), each->size()))
      faults << cut(*each, each->accessibleName(), each->sizeHint(), each->size());
  for (const auto* each : visible<ui::FittedWords>(window))
    if (!each->isWhole()) faults << nameOf(*each, each->words()) + " is cut in its smallest size";
  faults.removeAll(QString());
  return faults;
}

QStringList misplacedParts(const QWidget& window) {
  QStringList faults;
  const auto parts = visible<QWidget>(window);
  for (const auto* each : parts)
    if (!each->isWindow() && !each->size().isEmpty()) faults << outside(*each);
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (std::size_t k = i + 1; k < parts.size(); ++k) {
      const QWidget &a = *parts[i], &b = *parts[k];
      if (a.parentWidget() != b.parentWidget() || a.isWindow() || b.isWindow()) continue;
      if (a.testAttribute(Qt::WA_TransparentForMouseEvents) ||
          b.testAttribute(Qt::WA_TransparentForMouseEvents))
        continue;
      const QRect both = a.geometry() & b.geometry();
      if (both.width() > kRounding_px && both.height() > kRounding_px)
        faults << placed(b, "covers a part of", a);
    }
  faults.removeAll(QString());
  return faults;
}

ButtonPlaces::ButtonPlaces(const QWidget& window) : window_(window), places_(placesIn(window)) {}

std::vector<ButtonPlaces::Place> ButtonPlaces::placesIn(const QWidget& window) {
  std::vector<Place> places;
  for (const auto* button : visible<QAbstractButton>(window))
    places.push_back({button, QRect(button->mapTo(&window, QPoint()), button->size())});
  return places;
}

QStringList ButtonPlaces::moved(const QPoint& mouse) const {
  QStringList faults;
  QPointer<const QAbstractButton> before;
  bool was_on_button = false;
  for (const auto& [button, at] : places_)
    if (at.contains(mouse)) before = button, was_on_button = true;
  for (const auto& now : placesIn(window_)) {
    const bool is_gone = was_on_button && (!before || !before->isVisible());
    if (is_gone && now.at.contains(mouse))
      faults << nameOf(*now.button, now.button->text()) + " lies under the mouse in place of another button";
    for (const auto& was : places_) {
      if (was.button != now.button) continue;
      const QPoint by = now.at.topLeft() - was.at.topLeft();
      if (by.manhattanLength() > kStill_px)
        faults << QString("%1 moved by %2,%3 px")
                      .arg(nameOf(*now.button, now.button->text()))
                      .arg(by.x())
                      .arg(by.y());
    }
  }
  return faults;
}

}  // namespace facenav::testing
