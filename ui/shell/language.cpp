#include "shell/language.h"

#include <QCoreApplication>
#include <QDir>
#include <QFontMetrics>
#include <QImage>
#include <QLibraryInfo>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <QSettings>
#include <QTranslator>
#include <algorithm>
#include <filesystem>

#include "facenav/pictures/picture_words.h"
#include "facenav/report/report_language.h"
#include "facenav/scene/text_font.h"
#include "shell/shown_words.h"

/// The linker drops a static library's resources unless they are initialised (the macro needs the global
/// namespace).
static void initialiseLanguages() { Q_INIT_RESOURCE(languages); }

namespace facenav::ui {
namespace {

const char* const kRemembered = "appearance/language";
const char* const kEnglish = "en";
const char* const kInForce = "language";  // property of the application
constexpr double kEdge_px = 3;            // edge of letters in a picture, half of it outside
constexpr int kLeast_px = 8;              // smallest letters in a picture

/// "ja" of "ja_JP" or "ja-JP"; empty if there is no such language here.
QString known(const QString& locale) {
  const QString code = QString(locale).replace('-', '_').section('_', 0, 0).toLower();
  const auto all = languages();
  const bool is_known =
      std::any_of(all.begin(), all.end(), [&](const auto& one) { return one.code == code; });
  return is_known ? code : QString();
}

/// Gives the translator to the application, which deletes it when another language comes.
void install(QCoreApplication& application, const QString& name, const QString& folder) {
  auto* translator = new QTranslator(&application);
  if (translator->load(name, folder))
    QCoreApplication::installTranslator(translator);
  else
    delete translator;
}

/// Paints and translates words in a camera's picture; smaller where they would leave it.
void paintPictureWords(const pictures::PicturePixels& on, const pictures::PictureWords& words) {
  QImage image(on.rgb, on.width_px, on.height_px, int(on.row_bytes), QImage::Format_RGB888);
  QPainter painter(&image);
  const QString shown = shownWords(words.text);
  const int room_px = on.width_px - words.left_px;
  QFont font;
  font.setPixelSize(std::max(kLeast_px, words.height_px * 5 / 3));  // letters of other scripts are finer
  while (font.pixelSize() > kLeast_px && QFontMetrics(font).horizontalAdvance(shown) > room_px)
    font.setPixelSize(font.pixelSize() - 1);
  QPainterPath letters;
  letters.addText(words.left_px, words.base_px, font, shown);
  painter.setRenderHint(QPainter::Antialiasing);
  const auto of = [](const pictures::PictureColour& rgb) { return QColor(rgb[0], rgb[1], rgb[2]); };
  if (words.edge) painter.strokePath(letters, QPen(of(*words.edge), kEdge_px));
  painter.fillPath(letters, of(words.colour));
}

/// Letters for the scenes: Debian's Japanese font, whichever is installed, and DejaVu. A name may have
/// Japanese letters in a window of any language.
scene::TextFonts sceneFonts(const QString& code) {
  const auto installed = [](const char* file) {
    const auto font = std::filesystem::path("/usr/share/fonts/truetype") / file;
    return std::filesystem::exists(font) ? font : std::filesystem::path();
  };
  const auto japanese = installed("fonts-japanese-gothic.ttf"), western = installed("dejavu/DejaVuSans.ttf");
  if (code == kEnglish) return {{}, japanese};
  return code == "ja" ? scene::TextFonts{japanese, japanese} : scene::TextFonts{western, japanese};
}

}  // namespace

std::vector<Language> languages() {
  initialiseLanguages();
  std::vector<Language> all{{kEnglish, "English"}};
  for (const QString& file : QDir(":/languages").entryList({"facenav_*.qm"}, QDir::Files, QDir::Name)) {
    const QString code = file.section('_', 1).section('.', 0, 0);
    all.push_back({code, QLocale(code).nativeLanguageName()});
  }
  return all;
}

QString languageInForce() {
  const QVariant code = qApp ? qApp->property(kInForce) : QVariant();
  return code.isValid() ? code.toString() : QString(kEnglish);
}

QString wantedLanguage() {
  QStringList wanted{qEnvironmentVariable("FACENAV_LANGUAGE"), rememberedLanguage()};
  for (const QString& each : wanted)
    if (const QString code = known(each); !code.isEmpty()) return code;
  for (const QString& each : QLocale::system().uiLanguages())
    if (const QString code = known(each); !code.isEmpty()) return code;
  return kEnglish;
}

QString rememberedLanguage() { return QSettings().value(kRemembered).toString(); }

void rememberLanguage(const QString& code) { QSettings().setValue(kRemembered, code); }

void applyLanguage(QCoreApplication& application, const QString& code) {
  qDeleteAll(application.findChildren<QTranslator*>(QString(), Qt::FindDirectChildrenOnly));
  const QString taken = known(code).isEmpty() ? QString(kEnglish) : known(code);
  application.setProperty(kInForce, taken);
  const bool is_english = taken == kEnglish;
  pictures::setWordsPainter(is_english ? pictures::WordsPainter() : paintPictureWords);
  scene::setTextFonts(sceneFonts(taken));
  if (is_english) return useSentencesOf({});
  install(application, "qtbase_" + taken, QLibraryInfo::location(QLibraryInfo::TranslationsPath));
  install(application, "facenav_" + taken, ":/languages");
  useSentencesOf(report::catalogueText(taken.toStdString()));
}

}  // namespace facenav::ui
