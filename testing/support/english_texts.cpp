#include "support/english_texts.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QComboBox>
#include <QFontMetrics>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QTabBar>
#include <QTextDocument>
#include <utility>
#include <vector>

#include "home/fitted_words.h"
#include "shell/users_words.h"

namespace facenav::testing {
namespace {

constexpr int kMostRows = 60;  // of a table that are read

/// Words that stay: names of programs, formats, methods, scales and keys.
const QStringList& kept() {
  static const QStringList kWords{"FaceNav",
                                  "MRI",
                                  "MEP",
                                  "MEPs",
                                  "EMG",
                                  "EEG",
                                  "TMS",
                                  "rTMS",
                                  "DLPFC",
                                  "SMA",
                                  "DICOM",
                                  "NIfTI",
                                  "PDF",
                                  "CSV",
                                  "PACS",
                                  "JSON",
                                  "XDF",
                                  "OpenIGTLink",
                                  "IGTLink",
                                  "SimNIBS",
                                  "Beam",
                                  "Ctrl",
                                  "Shift",
                                  "Alt",
                                  "Return",
                                  "Esc",
                                  "Del",
                                  "Home",
                                  "End",
                                  "Tab",
                                  "Brainsight",
                                  "Localite",
                                  "Nexstim",
                                  "NBS",
                                  "GUM",
                                  "RAS",
                                  "LPS",
                                  "MNI",
                                  "ID",
                                  "BIDS",
                                  "Space",
                                  "Left",
                                  "Right",
                                  "Page",
                                  "Enter",
                                  "Down",
                                  "PgUp",
                                  "PgDown",
                                  "SofTaxic",
                                  "Slicer",
                                  "NaviNIBS",
                                  "InstrumentMarker",
                                  "TriggerMarkers",
                                  "InVesalius",
                                  "ANT",
                                  "PEM",
                                  "TLS",
                                  "YYYYMMDD",
                                  "sform",
                                  "qform",
                                  "form",
                                  "Fpz",
                                  "Yousry",
                                  "Jasper",
                                  "Fox",
                                  "GET",
                                  "MOVE",
                                  "ECHO",
                                  "deg",
                                  "utc",
                                  "lsl",
                                  "udp",
                                  "tcp",
                                  "serial",
                                  "sound",
                                  "igtl",
                                  "osc",
                                  "json",
                                  "LabRecorder",
                                  "Colin",
                                  "AAL",
                                  "Webcam",
                                  "ITK",
                                  "SVG",
                                  "rms",
                                  "samples",
                                  "USB",
                                  "UTC",
                                  "AprilTag",
                                  "aruco",
                                  "English"};
  return kWords;
}

struct Text {
  QString words, kind;
};

QString withoutTags(const QString& text) {
  if (!Qt::mightBeRichText(text)) return text;
  QTextDocument document;
  document.setHtml(text);
  return document.toPlainText();
}

void addActions(const QList<QAction*>& actions, std::vector<Text>& texts) {
  for (const auto* action : actions) {
    texts.push_back({action->text().section('\t', 0, 0), "menu"});
    if (action->toolTip() != action->iconText()) texts.push_back({action->toolTip(), "tip of menu"});
    if (action->menu()) addActions(action->menu()->actions(), texts);
  }
}

void addCells(const QAbstractItemView& view, std::vector<Text>& texts) {
  const auto* model = view.model();
  if (!model) return;
  for (int row = 0; row < std::min(kMostRows, model->rowCount()); ++row)
    for (int column = 0; column < model->columnCount(); ++column) {
      const QModelIndex cell = model->index(row, column);
      texts.push_back({cell.data().toString(), "cell"});
      texts.push_back({cell.data(Qt::ToolTipRole).toString(), "tip of cell"});
    }
}

/// What the widget itself shows.
std::vector<Text> shownBy(const QWidget& widget) {
  std::vector<Text> texts;
  if (const auto* label = qobject_cast<const QLabel*>(&widget)) texts.push_back({label->text(), "label"});
  if (const auto* button = qobject_cast<const QAbstractButton*>(&widget))
    texts.push_back({button->text(), "button"});
  if (const auto* fitted = qobject_cast<const ui::FittedWords*>(&widget))
    texts.push_back({fitted->words(), "words"});
  if (const auto* box = qobject_cast<const QGroupBox*>(&widget)) texts.push_back({box->title(), "box"});
  if (const auto* field = qobject_cast<const QLineEdit*>(&widget))
    texts.push_back({field->placeholderText(), "hint"});
  if (const auto* tabs = qobject_cast<const QTabBar*>(&widget))
    for (int i = 0; i < tabs->count(); ++i) {
      texts.push_back({tabs->tabText(i), "tab"});
      texts.push_back({tabs->tabToolTip(i), "tip of tab"});
    }
  if (const auto* choice = qobject_cast<const QComboBox*>(&widget))
    for (int i = 0; i < choice->count(); ++i) texts.push_back({choice->itemText(i), "choice"});
  if (const auto* header = qobject_cast<const QHeaderView*>(&widget)) {
    for (int i = 0; i < header->count(); ++i)
      for (const int role : {Qt::DisplayRole, Qt::ToolTipRole})
        texts.push_back({header->model()->headerData(i, header->orientation(), role).toString(), "heading"});
  } else if (const auto* view = qobject_cast<const QAbstractItemView*>(&widget)) {
    addCells(*view, texts);
  }
  if (const auto* menu = qobject_cast<const QMenu*>(&widget)) addActions(menu->actions(), texts);
  if (const auto* bar = qobject_cast<const QMenuBar*>(&widget)) addActions(bar->actions(), texts);
  return texts;
}

std::vector<Text> textsOf(const QWidget& widget) {
  std::vector<Text> texts;
  if (!ui::holdsUsersWords(widget)) texts = shownBy(widget);
  if (widget.isWindow()) texts.push_back({widget.windowTitle(), "title"});
  if (!ui::holdsUsersWords(widget)) texts.push_back({widget.toolTip(), "tip"});
  texts.push_back({widget.accessibleName(), "name"});
  for (auto& text : texts) text.words = withoutTags(text.words).remove('&');
  return texts;
}

std::vector<const QWidget*> visibleWidgets(const QWidget& window) {
  std::vector<const QWidget*> found{&window};
  for (const auto* widget : window.findChildren<QWidget*>())
    if (widget->isVisible() && widget->window() == window.window() && !widget->objectName().startsWith("qt_"))
      found.push_back(widget);
  return found;
}

QString englishWordIn(QString text, const QStringList& users_words) {
  for (const QString& words : users_words) text.remove(words, Qt::CaseInsensitive);
  static const QRegularExpression kFiles(
      "[~/"
      "*][^\\s]*|\\b[\\w*-]+\\.(yml|yaml|wav|json|csv|txt|html|trk|tck|trx|vtk|vtp|ply|stl|obj|hdr|img|svg|"
      "png|"
      "zip|gz|nii|msh|xdf|md|pdf|log|dcm)\\b|"
      "v4l2:\\S*|\\b(udp|tcp|serial|lsl|sound|igtl|osc|json|invesalius)[:\\[][\\[\\]:A-Za-z=.]*|facenav "
      "[\\w-]+( \\w+)?|\\.\\w+|`[^`]*`|\\b\\w+_\\w+|:[a-z]+(=[A-Z]+)?|「Field」|\\b\\w*\\d\\w*\\b");
  text.remove(kFiles);
  static const QRegularExpression kWord("[A-Za-z]{3,}");
  for (auto it = kWord.globalMatch(text); it.hasNext();) {
    const QString word = it.next().captured();
    if (!kept().contains(word)) return word;
  }
  return {};
}

QString described(const QWidget& widget, const Text& text, const QString& why) {
  return QString("%1 in %2 '%3' (%4) of %5")
      .arg(why, text.kind, text.words.simplified(),
           QString(widget.metaObject()->className()).remove("facenav::ui::"),
           widget.parentWidget()
               ? QString(widget.parentWidget()->metaObject()->className()).remove("facenav::ui::")
               : QString("no widget"));
}

}  // namespace

QStringList englishTexts(const QWidget& window, const QStringList& users_words) {
  QStringList faults;
  for (const auto* widget : visibleWidgets(window))
    for (const auto& text : textsOf(*widget))
      if (const QString word = englishWordIn(text.words, users_words); !word.isEmpty())
        faults << described(*widget, text, "the English word " + word);
  faults.removeDuplicates();
  return faults;
}

QStringList unreadableTexts(const QWidget& window) {
  QStringList faults;
  for (const auto* widget : visibleWidgets(window))
    for (const auto& text : textsOf(*widget))
      for (const uint letter : text.words.toUcs4())
        if (letter >= ' ' && !QFontMetrics(widget->font()).inFontUcs4(letter)) {
          faults << described(*widget, text, QString("no font has the letter U+%1").arg(letter, 4, 16));
          break;
        }
  faults.removeDuplicates();
  return faults;
}

}  // namespace facenav::testing
