#pragma once
// Theme: the window's colours by name, each for the dark and the light theme. The table in theme.cpp is their
// only place: the style sheet (resources/qss/facenav.qss) names them as @name, code asks themeColour().
// Medical pictures are black in both themes. Blue and orange can be told apart without red and green; words
// and shapes say each state as well.

#include <QColor>
#include <QObject>
#include <QString>
#include <array>
#include <functional>
#include <vector>

class QApplication;

namespace facenav::ui {

enum class Theme { dark, light };
/// What a person chooses; `system`: as the desktop's own colours are.
enum class ThemeChoice { dark, light, system };

/// Names of the colours, in the order of the table.
enum class Colour {
  // Grounds, from the outermost to the innermost.
  window,
  ground,
  panel,
  sunken,
  stripe,
  field,
  button,
  button_hover,
  button_off,
  tool_hover,
  chosen,
  accent,
  accent_hover,
  menu_chosen,
  good_ground,
  caution_ground,
  lost_ground,
  blank,
  warning,
  pause,
  chip,
  paper,
  picture,
  scene_low,
  scene_high,
  // Words.
  text,
  strong,
  muted,
  menu,
  disabled,
  on_chosen,
  on_accent,
  on_state,
  caution_words,
  stop_words,
  warning_words,
  pause_words,
  paper_text,
  picture_words,
  picture_text,
  link,
  // Lines, shapes and states.
  edge,
  line,
  accent_edge,
  focus,
  handle,
  pause_edge,
  good,
  caution,
  lost,
  now,
  stop,
  sign_quiet,
  bar_rest,
  grid,
  paper_line,
  paper_grid,
  paper_good,
  paper_caution,
  paper_excluded,
  count
};

Theme theme();
/// Colour in the theme that is in force.
QColor themeColour(Colour colour);
QColor themeColour(Colour colour, Theme of);
/// Red, green, blue from 0 to 1, as the scenes take it.
std::array<double, 3> themeRgb(Colour colour);
/// Name in the style sheet, without its @.
QString colourName(Colour colour);

/// Puts the theme's colours in the place of the names in a style sheet. An unknown name stays as it is.
QString withColours(const QString& sheet, Theme of);

/// Two colours that code draws on each other. `least`: contrast that WCAG 2.1 asks for, 4.5 for words, 3 for
/// shapes and for words that are large or disabled.
struct DrawnPair {
  Colour front, back;
  double least = 4.5;
};
const std::vector<DrawnPair>& drawnPairs();

/// Choice of the word "dark", "light" or "system"; dark for any other.
ThemeChoice themeChoiceNamed(const QString& word);
/// The choice that the next start uses; dark unless one was remembered.
ThemeChoice rememberedTheme();
void rememberTheme(ThemeChoice choice);
/// Sets the theme for applyAppearance(). `system` is judged by the desktop's palette, so call it first before
/// the first applyAppearance().
void useTheme(ThemeChoice choice);
/// Changes the theme while the program runs.
void changeTheme(QApplication& application, ThemeChoice choice);
/// Runs `apply` now, and again whenever the theme changes while `owner` lives: for colours that are kept.
void whenThemeChanges(QObject* owner, std::function<void()> apply);

/// Tells that the theme has changed; see whenThemeChanges().
class ThemeNotice : public QObject {
  Q_OBJECT

 public:
  static ThemeNotice& instance();

 signals:
  void changed();
};

/// Contrast ratio by WCAG 2.1, 1 to 21.
double contrast(const QColor& a, const QColor& b);

}  // namespace facenav::ui
