// The themes: every colour comes from the one table, every word stands out from its ground in both themes by
// WCAG 2.1, and another theme holds at once.

#include "shell/theme.h"

#include <gmock/gmock.h>

#include <QApplication>
#include <QDirIterator>
#include <QFile>
#include <QLabel>
#include <QMenuBar>
#include <QPainter>
#include <QRegularExpression>
#include <QSettings>
#include <map>

#include "facenav/scene/display.h"
#include "facenav/scene/palette.h"
#include "gui_fixtures.h"
#include "shell/appearance.h"
#include "shell/main_window.h"
#include "shell/scene_view.h"
#include "shell/status_chip.h"

namespace facenav::ui {
namespace {

constexpr double kWords = 4.5, kLargeOrDisabled = 3.0;  // WCAG 2.1, success criterion 1.4.3
constexpr Theme kThemes[] = {Theme::dark, Theme::light};

const char* wordOf(Theme theme) { return theme == Theme::dark ? "dark" : "light"; }

/// One part of the style sheet: what it sets for one selector.
struct SheetRule {
  QString selector;
  std::map<QString, QString> values;
};

QString sheetText() {
  QFile file(":/facenav/facenav.qss");
  EXPECT_TRUE(file.open(QIODevice::ReadOnly));
  static const QRegularExpression kComment("/\\*.*\\*/");
  return QString::fromUtf8(file.readAll()).remove(kComment);
}

std::vector<SheetRule> rulesOf(const QString& sheet) {
  std::vector<SheetRule> rules;
  static const QRegularExpression kRule("([^{}]+)\\{([^}]*)\\}"), kValue("([a-z-]+):\\s*([^;]+)");
  for (auto it = kRule.globalMatch(sheet); it.hasNext();) {
    const auto match = it.next();
    for (const QString& selector : match.captured(1).split(',')) {
      SheetRule rule{selector.simplified(), {}};
      for (auto value = kValue.globalMatch(match.captured(2)); value.hasNext();) {
        const auto each = value.next();
        rule.values[each.captured(1)] = each.captured(2).simplified();
      }
      rules.push_back(rule);
    }
  }
  return rules;
}

/// Selectors whose rules also hold for a widget that this one fits, the nearest first: without states and
/// attributes, without the parts around it, and the class alone.
QStringList alsoHolding(const QString& selector) {
  static const QRegularExpression kState("(?<!:):(?!:)[a-z-]+|\\[[^\\]]*\\]");
  QStringList out{selector};
  const QString plain = QString(selector).remove(kState), own = plain.section(' ', -1);
  out << plain << own;
  if (own.contains('#')) out << '#' + own.section('#', 1) << own.section('#', 0, 0);
  out.removeAll(QString());
  out.removeDuplicates();
  return out;
}

/// Value of a property for a selector: its own, or that of a rule that also holds.
QString valueFor(const std::vector<SheetRule>& rules, const QString& selector, const QString& name) {
  for (const QString& each : alsoHolding(selector))
    for (const auto& rule : rules)
      if (rule.selector == each && rule.values.count(name)) return rule.values.at(name);
  return {};
}

/// Ground of the parts around it, for "#warning QLabel"; empty: any panel.
QString groundAround(const std::vector<SheetRule>& rules, const QString& selector) {
  const QStringList parts = selector.split(' ');
  for (int i = parts.size() - 2; i >= 0; --i) {
    const QString ground = valueFor(rules, parts[i], "background");
    if (!ground.isEmpty()) return ground;
  }
  return {};
}

QColor resolved(const QString& named, Theme theme) { return QColor(withColours(named, theme)); }

TEST(Theme, EveryWordOfTheStyleSheetStandsOutFromItsGround) {
  const auto rules = rulesOf(sheetText());
  const QStringList anywhere{"@window", "@ground", "@panel", "@sunken"};
  int checked = 0;
  for (const Theme theme : kThemes)
    for (const auto& rule : rules) {
      const bool sets_colours = rule.values.count("color") || rule.values.count("background");
      const bool has_words = !rule.selector.contains("::indicator") &&
                             !rule.selector.startsWith("QScrollBar") && !rule.selector.endsWith("::chunk");
      if (!sets_colours || !has_words) continue;
      QString words = valueFor(rules, rule.selector, "color");
      if (words.isEmpty()) words = "@text";
      QString own = valueFor(rules, rule.selector, "background");
      if (own == "transparent") own.clear();
      if (own.isEmpty()) own = groundAround(rules, rule.selector);
      const double least = rule.selector.contains(":disabled") ? kLargeOrDisabled : kWords;
      for (const QString& behind : own.isEmpty() ? anywhere : QStringList{own}) {
        ++checked;
        EXPECT_GE(contrast(resolved(words, theme), resolved(behind, theme)), least)
            << wordOf(theme) << ": " << rule.selector.toStdString() << ", " << words.toStdString() << " on "
            << behind.toStdString();
      }
    }
  EXPECT_GT(checked, 150);
}

TEST(Theme, SelectedLinesOfTablesStandOut) {
  for (const Theme theme : kThemes)
    for (const auto& rule : rulesOf(sheetText()))
      if (rule.values.count("selection-color")) {
        EXPECT_GE(contrast(resolved(rule.values.at("selection-color"), theme),
                           resolved(rule.values.at("selection-background-color"), theme)),
                  kWords)
            << wordOf(theme);
        EXPECT_GE(
            contrast(resolved("@text", theme), resolved(rule.values.at("alternate-background-color"), theme)),
            kWords)
            << wordOf(theme);
      }
}

TEST(Theme, WhatCodeDrawsStandsOutFromItsGround) {
  for (const Theme theme : kThemes)
    for (const auto& pair : drawnPairs()) {
      EXPECT_GE(contrast(themeColour(pair.front, theme), themeColour(pair.back, theme)), pair.least)
          << wordOf(theme) << ": " << colourName(pair.front).toStdString() << " on "
          << colourName(pair.back).toStdString();
    }
}

TEST(Theme, ContrastIsThatOfWcag) {
  EXPECT_NEAR(contrast(Qt::black, Qt::white), 21.0, 1e-9);
  EXPECT_NEAR(contrast(QColor("#777777"), Qt::white), 4.48, 0.01);  // the well-known grey that just fails
}

TEST(Theme, TheStyleSheetNamesOnlyColoursOfTheTable) {
  const QString sheet = sheetText();
  EXPECT_FALSE(sheet.contains(QRegularExpression("#[0-9a-fA-F]{3,8}\\b(?=[^{}]*\\})")))
      << "a colour by number";
  for (const Theme theme : kThemes) EXPECT_FALSE(withColours(sheet, theme).contains('@'));
}

/// Screens that show patterns for cameras, and paper, have the same colours in each theme.
bool hasFixedColours(const QString& file) {
  for (const char* each : {"theme.cpp", "board_screen.cpp", "latency_screen.cpp", "projector_screen.cpp",
                           "projector_code_screen.cpp", "report_pdf.cpp"})
    if (file == each) return true;
  return false;
}

TEST(Theme, NoOtherCodeOfTheWindowHasAColourOfItsOwn) {
  const QRegularExpression own(
      "QColor\\(\\s*[0-9\"]|\"#[0-9a-fA-F]{6}\"|Qt::(white|black|red|green|blue|yellow|cyan|magenta|"
      "(dark|light)?[gG]ray|dark[A-Z][a-z]+)\\b|setStyleSheet");
  int files = 0;
  for (QDirIterator it(QString(FACENAV_SOURCE_DIR) + "/ui", {"*.cpp", "*.h"}, QDir::Files,
                       QDirIterator::Subdirectories);
       it.hasNext();) {
    QFile file(it.next());
    if (hasFixedColours(it.fileName())) continue;
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    ++files;
    const QStringList lines = QString::fromUtf8(file.readAll()).split('\n');
    for (int i = 0; i < lines.size(); ++i) {
      const bool is_sheet_of_application = lines[i].contains("application.setStyleSheet");
      EXPECT_FALSE(lines[i].contains(own) && !is_sheet_of_application)
          << it.fileName().toStdString() << ":" << i + 1;
    }
  }
  EXPECT_GT(files, 100);
}

TEST(Theme, TheDarkColoursAreThoseOfAllPictures) {
  namespace palette = scene::palette;
  const std::pair<Colour, palette::Rgb> shared[] = {{Colour::ground, palette::kBackground},
                                                    {Colour::scene_low, palette::kBackground},
                                                    {Colour::scene_high, palette::kBackgroundTop},
                                                    {Colour::panel, palette::kPanel},
                                                    {Colour::line, palette::kLine},
                                                    {Colour::text, palette::kText},
                                                    {Colour::muted, palette::kMuted},
                                                    {Colour::good, palette::kBlue},
                                                    {Colour::caution, palette::kOrange}};
  for (const auto& [colour, rgb] : shared) {
    const QColor ours = themeColour(colour, Theme::dark);
    const double found[3] = {ours.redF(), ours.greenF(), ours.blueF()};
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(found[i], rgb[i], 0.006) << colourName(colour).toStdString();
  }
}

QAction* themeAction(MainWindow& window, const QString& words) {
  for (auto* each : window.findChildren<QAction*>())
    if (QString(each->text()).remove('&') == words) return each;
  return nullptr;
}

TEST(Theme, AnotherThemeHoldsAtOnceAndAtTheNextStart) {
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  QSettings().clear();
  MainWindow window{Services{}};
  window.show();
  QApplication::processEvents();
  const auto corner = [&] {
    return window.grab(QRect(2, window.height() - 6, 1, 1)).toImage().pixelColor(0, 0);
  };
  EXPECT_EQ(corner(), themeColour(Colour::ground, Theme::dark)) << "the task bar";
  EXPECT_TRUE(themeAction(window, "Dark")->isChecked());
  themeAction(window, "Light")->trigger();
  QApplication::processEvents();
  EXPECT_EQ(rememberedTheme(), ThemeChoice::light);
  EXPECT_EQ(corner(), themeColour(Colour::ground, Theme::light));
  EXPECT_EQ(QApplication::palette().color(QPalette::Window), themeColour(Colour::window, Theme::light));
  themeAction(window, "Dark")->trigger();
  QApplication::processEvents();
  EXPECT_EQ(corner(), themeColour(Colour::ground, Theme::dark));
  EXPECT_DOUBLE_EQ(textScale(), 1.0);
  QSettings().clear();
}

TEST(Theme, TheSceneAndTheStatesFollowTheTheme) {
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  SceneView view;
  const auto topCorner = [&] {
    const RgbImage picture = view.scene().render(60, 40);
    return QColor(picture.rgb[0], picture.rgb[1], picture.rgb[2]);
  };
  const auto isNear = [](const QColor& a, const QColor& b) {
    return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) + std::abs(a.blue() - b.blue()) < 12;
  };
  for (const auto choice : {ThemeChoice::light, ThemeChoice::dark}) {
    changeTheme(*qApp, choice);
    EXPECT_TRUE(isNear(topCorner(), themeColour(Colour::scene_high))) << topCorner().name().toStdString();
    EXPECT_EQ(colourOf(Level::good), themeColour(Colour::good));
  }
  changeTheme(*qApp, ThemeChoice::dark);
}

TEST(Theme, TheSystemsChoiceIsThatOfTheDesktopsPalette) {
  useTheme(ThemeChoice::system);
  const bool is_dark = qApp->property("desktop_is_dark").toBool();
  EXPECT_EQ(theme(), is_dark ? Theme::dark : Theme::light);
  qApp->setProperty("desktop_is_dark", !is_dark);
  useTheme(ThemeChoice::system);
  EXPECT_EQ(theme(), is_dark ? Theme::light : Theme::dark);
  qApp->setProperty("desktop_is_dark", is_dark);
  useTheme(ThemeChoice::dark);
}

}  // namespace
}  // namespace facenav::ui
