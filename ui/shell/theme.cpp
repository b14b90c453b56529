#include "shell/theme.h"

#include <QApplication>
#include <QPalette>
#include <QRegularExpression>
#include <QSettings>
#include <QVariant>
#include <algorithm>
#include <cmath>

#include "shell/appearance.h"

namespace facenav::ui {
namespace {

const char* const kTheme = "theme";                       // property of the application
const char* const kDesktopIsDark = "desktop_is_dark";     // property of the application
const char* const kRememberedTheme = "appearance/theme";  // "dark", "light" or "system"
constexpr const char* kChoices[] = {"dark", "light", "system"};

struct Row {
  Colour colour;
  const char *name, *dark, *light;
};

/// The one table of the window's colours.
constexpr Row kTable[] = {
    {Colour::window, "window", "#10141a", "#eef1f5"},
    {Colour::ground, "ground", "#0b0d10", "#e1e7ee"},
    {Colour::panel, "panel", "#15191f", "#f8fafc"},
    {Colour::sunken, "sunken", "#0e1217", "#ffffff"},
    {Colour::stripe, "stripe", "#12171d", "#f2f5f8"},
    {Colour::field, "field", "#0b0d10", "#ffffff"},
    {Colour::button, "button", "#20272f", "#e2e8f0"},
    {Colour::button_hover, "button_hover", "#2a333e", "#d3dce6"},
    {Colour::button_off, "button_off", "#171b21", "#edf0f4"},
    {Colour::tool_hover, "tool_hover", "#1a2028", "#dde5ee"},
    {Colour::chosen, "chosen", "#1d3b57", "#cbe2f7"},
    {Colour::accent, "accent", "#2272bb", "#1a67ac"},
    {Colour::accent_hover, "accent_hover", "#2878bf", "#15578f"},
    {Colour::menu_chosen, "menu_chosen", "#265c8c", "#1a67ac"},
    {Colour::good_ground, "good_ground", "#54b2ff", "#7cc4ff"},
    {Colour::caution_ground, "caution_ground", "#ffa033", "#ffb04d"},
    {Colour::lost_ground, "lost_ground", "#a5aab2", "#b9c0c9"},
    {Colour::blank, "blank", "#ffffff", "#ffffff"},
    {Colour::warning, "warning", "#3a2a10", "#fff0d9"},
    {Colour::pause, "pause", "#3d3566", "#e6e0ff"},
    {Colour::chip, "chip", "#161b22", "#ffffff"},
    {Colour::paper, "paper", "#ffffff", "#ffffff"},
    {Colour::picture, "picture", "#000000", "#000000"},
    {Colour::scene_low, "scene_low", "#0b0d10", "#2b343d"},
    {Colour::scene_high, "scene_high", "#181d24", "#46515d"},
    {Colour::text, "text", "#edf1f5", "#16202b"},
    {Colour::strong, "strong", "#ffffff", "#000000"},
    {Colour::muted, "muted", "#9eabb8", "#4a5663"},
    {Colour::menu, "menu", "#c9d2da", "#26323f"},
    {Colour::disabled, "disabled", "#6e7680", "#737d88"},
    {Colour::on_chosen, "on_chosen", "#ffffff", "#0b2b47"},
    {Colour::on_accent, "on_accent", "#ffffff", "#ffffff"},
    {Colour::on_state, "on_state", "#0b0d10", "#0b0d10"},
    {Colour::caution_words, "caution_words", "#ffb25c", "#8a4300"},
    {Colour::stop_words, "stop_words", "#ff8c82", "#a5231c"},
    {Colour::warning_words, "warning_words", "#ffd9a6", "#6b3600"},
    {Colour::pause_words, "pause_words", "#ffffff", "#1f1650"},
    {Colour::paper_text, "paper_text", "#1d2430", "#1d2430"},
    {Colour::picture_words, "picture_words", "#9eabb8", "#9eabb8"},
    {Colour::picture_text, "picture_text", "#ffffff", "#ffffff"},
    {Colour::link, "link", "#78beff", "#0b57a4"},
    {Colour::edge, "edge", "#232a33", "#c6d0da"},
    {Colour::line, "line", "#333c47", "#8793a0"},
    {Colour::accent_edge, "accent_edge", "#2f86d2", "#15578f"},
    {Colour::focus, "focus", "#6db8f7", "#0b57a4"},
    {Colour::handle, "handle", "#6a7787", "#7d8996"},
    {Colour::pause_edge, "pause_edge", "#c8b8ff", "#5b45b0"},
    {Colour::good, "good", "#54b2ff", "#0a62a8"},
    {Colour::caution, "caution", "#ffa033", "#a85400"},
    {Colour::lost, "lost", "#a5aab2", "#5b6570"},
    {Colour::now, "now", "#ffc43c", "#8f5300"},
    {Colour::stop, "stop", "#e2574c", "#c62f28"},
    {Colour::sign_quiet, "sign_quiet", "#66717d", "#7d8996"},
    {Colour::bar_rest, "bar_rest", "#333c47", "#c6d0da"},
    {Colour::grid, "grid", "#2a333e", "#ccd3dc"},
    {Colour::paper_line, "paper_line", "#1d2430", "#1d2430"},
    {Colour::paper_grid, "paper_grid", "#ccd3dc", "#ccd3dc"},
    {Colour::paper_good, "paper_good", "#0072b2", "#0072b2"},
    {Colour::paper_caution, "paper_caution", "#d55e00", "#d55e00"},
    {Colour::paper_excluded, "paper_excluded", "#7f8894", "#7f8894"},
};

constexpr bool isInOrder() {
  for (int i = 0; i < int(Colour::count); ++i)
    if (int(kTable[i].colour) != i) return false;
  return std::size(kTable) == std::size_t(Colour::count);
}
static_assert(isInOrder(), "the table has one row for each colour, in the order of the names");

constexpr double kShape = 3.0;  // least contrast of shapes, and of words that are large or disabled

constexpr DrawnPair kDrawn[] = {
    // The palette: words in widgets without a rule of their own.
    {Colour::text, Colour::window},
    {Colour::text, Colour::field},
    {Colour::text, Colour::panel},
    {Colour::text, Colour::button},
    {Colour::on_accent, Colour::menu_chosen},
    {Colour::link, Colour::field},
    {Colour::link, Colour::panel},
    {Colour::muted, Colour::field},
    {Colour::disabled, Colour::button, kShape},
    {Colour::disabled, Colour::field, kShape},
    {Colour::disabled, Colour::window, kShape},
    // Chips, marks of the worklist, the second screen.
    {Colour::text, Colour::chip},
    {Colour::good, Colour::chip, kShape},
    {Colour::caution, Colour::chip, kShape},
    {Colour::lost, Colour::chip, kShape},
    {Colour::good, Colour::sunken, kShape},
    {Colour::caution, Colour::sunken, kShape},
    {Colour::lost, Colour::sunken, kShape},
    {Colour::text, Colour::ground},
    {Colour::muted, Colour::ground},
    {Colour::good, Colour::ground, kShape},
    {Colour::caution, Colour::ground, kShape},
    {Colour::lost, Colour::ground, kShape},
    // Lists of findings and series, the table of pulses.
    {Colour::link, Colour::sunken},
    {Colour::caution_words, Colour::sunken},
    {Colour::text, Colour::sunken},
    {Colour::muted, Colour::sunken},
    {Colour::muted, Colour::stripe},
    // Charts and the time strip.
    {Colour::text, Colour::field},
    {Colour::good, Colour::field, kShape},
    {Colour::caution, Colour::field, kShape},
    {Colour::lost, Colour::field, kShape},
    {Colour::paper_text, Colour::paper},
    {Colour::paper_good, Colour::paper, kShape},
    {Colour::paper_caution, Colour::paper, kShape},
    {Colour::paper_excluded, Colour::paper, kShape},
    // Pictures and the scene.
    {Colour::picture_words, Colour::picture},
    {Colour::picture_text, Colour::picture},
    {Colour::picture_text, Colour::scene_high},
    {Colour::picture_words, Colour::scene_low, kShape},
    // The next colours are for home and for the set-up of the cameras.
    {Colour::now, Colour::window},
    {Colour::good, Colour::window},
    {Colour::stop_words, Colour::window},
    {Colour::muted, Colour::window},
    {Colour::stop, Colour::window, kShape},
    {Colour::on_accent, Colour::stop, kShape},
    {Colour::sign_quiet, Colour::window, kShape},
    {Colour::on_state, Colour::now, kShape},
    // What has the focus, and the bar of a scrolled part.
    {Colour::focus, Colour::window, kShape},
    {Colour::focus, Colour::panel, kShape},
    {Colour::focus, Colour::button, kShape},
    {Colour::focus, Colour::field, kShape},
    {Colour::focus, Colour::sunken, kShape},
    {Colour::handle, Colour::sunken, kShape}};

double luminance(const QColor& colour) {
  const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
  return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) + 0.0722 * linear(colour.blueF());
}

/// True if the desktop writes bright words on a dark ground. Found before the window sets its own colours.
bool isDesktopDark() {
  QVariant known = qApp->property(kDesktopIsDark);
  if (!known.isValid()) {
    const QPalette palette = QGuiApplication::palette();
    known = luminance(palette.color(QPalette::Window)) < luminance(palette.color(QPalette::WindowText));
    qApp->setProperty(kDesktopIsDark, known);
  }
  return known.toBool();
}

}  // namespace

Theme theme() {
  if (!QCoreApplication::instance()) return Theme::dark;
  isDesktopDark();
  return Theme(qApp->property(kTheme).toInt());
}

QColor themeColour(Colour colour) { return themeColour(colour, theme()); }

QColor themeColour(Colour colour, Theme of) {
  const Row& row = kTable[int(colour)];
  return QColor(of == Theme::dark ? row.dark : row.light);
}

std::array<double, 3> themeRgb(Colour colour) {
  const QColor c = themeColour(colour);
  return {c.redF(), c.greenF(), c.blueF()};
}

QString colourName(Colour colour) { return kTable[int(colour)].name; }

QString withColours(const QString& sheet, Theme of) {
  static const QRegularExpression kName("@([a-z_]+)");
  QString out;
  int done = 0;
  for (auto it = kName.globalMatch(sheet); it.hasNext();) {
    const auto match = it.next();
    const auto* row = std::find_if(std::begin(kTable), std::end(kTable),
                                   [&](const Row& each) { return match.captured(1) == each.name; });
    if (row == std::end(kTable)) continue;
    out += sheet.mid(done, match.capturedStart() - done) + (of == Theme::dark ? row->dark : row->light);
    done = match.capturedEnd();
  }
  return out + sheet.mid(done);
}

const std::vector<DrawnPair>& drawnPairs() {
  static const std::vector<DrawnPair> pairs(std::begin(kDrawn), std::end(kDrawn));
  return pairs;
}

ThemeChoice themeChoiceNamed(const QString& word) {
  for (int i = 0; i < 3; ++i)
    if (word == kChoices[i]) return ThemeChoice(i);
  return ThemeChoice::dark;
}

ThemeChoice rememberedTheme() { return themeChoiceNamed(QSettings().value(kRememberedTheme).toString()); }

void rememberTheme(ThemeChoice choice) { QSettings().setValue(kRememberedTheme, kChoices[int(choice)]); }

void useTheme(ThemeChoice choice) {
  const bool is_dark = choice == ThemeChoice::system ? isDesktopDark() : choice == ThemeChoice::dark;
  theme();  // knows the desktop from now on
  qApp->setProperty(kTheme, int(is_dark ? Theme::dark : Theme::light));
}

void changeTheme(QApplication& application, ThemeChoice choice) {
  const Theme before = theme();
  useTheme(choice);
  if (theme() == before) return;
  applyAppearance(application, textScale());
  emit ThemeNotice::instance().changed();
}

ThemeNotice& ThemeNotice::instance() {
  static ThemeNotice notice;
  return notice;
}

void whenThemeChanges(QObject* owner, std::function<void()> apply) {
  apply();
  QObject::connect(&ThemeNotice::instance(), &ThemeNotice::changed, owner, std::move(apply));
}

double contrast(const QColor& a, const QColor& b) {
  const double la = luminance(a), lb = luminance(b);
  return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

}  // namespace facenav::ui
