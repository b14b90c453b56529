#pragma once
// The language of a report. The report is made in English; here its words are put into another language by a
// catalogue (core/sentence_catalogue.h). Numbers, units and what a person wrote stay as they are.

#include <memory>
#include <string>
#include <vector>

#include "facenav/core/sentence_catalogue.h"
#include "facenav/report/session_report.h"

namespace facenav::report {

/// The languages that this program has besides English: "ja".
std::vector<std::string> languageCodes();
/// The catalogue of a language, the text of its .ts file; empty if there is none.
std::string catalogueText(const std::string& code);
/// The sentences of reports, of a catalogue's text.
std::shared_ptr<const SentenceCatalogue> reportSentences(const std::string& catalogue_text);
/// The sentences of reports in a language; null for English, "en". Throws Error if there is no such language.
std::shared_ptr<const SentenceCatalogue> languageOf(const std::string& code);

/// Puts the words of a report into the catalogue's language.
SessionReport inLanguage(SessionReport report, const SentenceCatalogue& language);

}  // namespace facenav::report
