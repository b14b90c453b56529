#pragma once
// The window's language: English, or one of the catalogues in resources/languages. It holds from the start of
// the program to its end. Logs, files and the report stay English.

#include <QString>
#include <vector>

class QCoreApplication;

namespace facenav::ui {

struct Language {
  QString code;  // "en", "ja": ISO 639
  QString name;  // in the language itself
};

/// English, then each language that the program has a catalogue of.
std::vector<Language> languages();
/// Code of the language in force; "en" until one was applied.
QString languageInForce();
/// Code of the language for this start: the environment's FACENAV_LANGUAGE, else the remembered one, else the
/// first of the system's that there is, else "en".
QString wantedLanguage();
/// The language that was chosen for the next start; empty: the system's.
QString rememberedLanguage();
void rememberLanguage(const QString& code);
/// Takes the texts of a language, and Qt's own in it; windows made from now on have them. An unknown code
/// gives English.
void applyLanguage(QCoreApplication& application, const QString& code);

}  // namespace facenav::ui
