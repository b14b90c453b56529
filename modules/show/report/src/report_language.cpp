#include "facenav/report/report_language.h"

#include <algorithm>

#include "facenav/core/error.h"
#include "language_table.h"
#include "report_html.h"

namespace facenav::report {
namespace {

constexpr const char* kEnglish = "en";
const std::vector<std::string> kContexts{"core", "report"};  // of a catalogue

/// The words of a text between two tags, in the other language.
std::string translatedNode(const std::string& html, const SentenceCatalogue& language) {
  if (html.find_first_not_of(" \n") == std::string::npos) return html;
  return escapedHtml(language.translated(plainWords(html)));
}

/// Translates all between the tags, but for the cells that say translate="no".
std::string translatedHtml(const std::string& html, const SentenceCatalogue& language) {
  std::string out;
  bool is_kept = false;
  for (std::size_t at = 0; at < html.size();) {
    const auto tag = std::min(html.size(), html.find('<', at));
    const std::string words = html.substr(at, tag - at);
    out += is_kept ? words : translatedNode(words, language);
    const auto end = std::min(html.size(), html.find('>', tag));
    const std::string mark = html.substr(tag, end + 1 - tag);
    if (!mark.empty()) is_kept = mark.find(kKeptMark) != std::string::npos;
    out += mark;
    at = end + 1;
  }
  return out;
}

}  // namespace

std::vector<std::string> languageCodes() {
  std::vector<std::string> codes;
  for (const auto& one : languageTable()) codes.emplace_back(one.code);
  return codes;
}

std::string catalogueText(const std::string& code) {
  for (const auto& one : languageTable())
    if (code == one.code) return std::string(one.catalogue);
  return {};
}

std::shared_ptr<const SentenceCatalogue> reportSentences(const std::string& catalogue_text) {
  if (catalogue_text.empty()) return nullptr;
  return std::make_shared<const SentenceCatalogue>(catalogue_text, kContexts);
}

std::shared_ptr<const SentenceCatalogue> languageOf(const std::string& code) {
  const std::string text = catalogueText(code);
  if (!text.empty() || code == kEnglish) return reportSentences(text);
  std::string all = kEnglish;
  for (const auto& each : languageCodes()) all += ", " + each;
  throw Error("there is no report in the language '" + code + "'", {}, "choose one of: " + all);
}

SessionReport inLanguage(SessionReport report, const SentenceCatalogue& language) {
  report.language = language.language();
  for (std::string* words : {&report.title, &report.subtitle, &report.page_words})
    *words = language.translated(*words);
  report.body = translatedHtml(report.body, language);
  for (auto& figure : report.figures)
    if (figure.chart)
      for (auto& shape : figure.chart->shapes) shape.text = language.translated(shape.text);
  return report;
}

}  // namespace facenav::report
