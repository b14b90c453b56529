// A report in another language: no English is left but names, what a person wrote, and units.

#include "facenav/report/report_language.h"

#include <gmock/gmock.h>

#include <regex>
#include <set>

#include "facenav/casefile/pulse_file.h"
#include "facenav/casefile/session_log.h"
#include "facenav/core/error.h"
#include "support/ball_case.h"
#include "support/test_data.h"
#include "unit/case/casefile/made_pulse.h"

namespace facenav::steps {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

class ReportLanguageTest : public ::testing::Test {
 protected:
  ReportLanguageTest()
      : store_(casefile::CaseStore::create(folder_.path() / "case", testing::ballCase(), {}, false)) {
    casefile::SessionLog log(store_.folder());
    session_ = log.folder();
    log.addEvent("session started");
    log.addEvent("operator", "no such operator");
    log.addEvent("adverse event", "not signed off");  // words of the catalogue, but a person wrote them
    log.addEvent("fault", "the case is not signed off");
    casefile::PulseFile pulses(session_);
    for (int i = 1; i <= 12; ++i) keep(pulses, casefile::madePulse(i, 0.3 * i), "the case is not signed off");
    keep(pulses, casefile::madeLostPulse(13), "face not found");
    casefile::editPulse(session_, {12, true, "excluded", ""});
  }
  static void keep(casefile::PulseFile& file, casefile::Pulse pulse, const std::string& reason) {
    if (!pulse.reason.empty()) pulse.reason = reason;
    file.keep(pulse);
  }
  report::SessionReport made(const std::string& language) const {
    report::ReportOptions options;
    options.language = report::languageOf(language);
    return report::makeSessionReport(store_, casefile::readSession(session_), options);
  }
  testing::TemporaryFolder folder_;
  casefile::CaseStore store_;
  std::filesystem::path session_;
};

/// English words of a text: two small letters or more. Not those of a unit, a file or a name.
std::set<std::string> englishWords(const std::string& text) {
  const std::set<std::string> kept{"mm", "deg", "FaceNav", "pulses.csv", "events.jsonl", "t_s", "uV"};
  static const std::regex kWord("[A-Za-z_.]*[a-z]{2,}[A-Za-z_.]*");
  std::set<std::string> found;
  for (std::sregex_iterator at(text.begin(), text.end(), kWord), end; at != end; ++at)
    if (!kept.count(at->str())) found.insert(at->str());
  return found;
}

std::string withoutTags(const std::string& html) {
  const std::string kept = std::regex_replace(html, std::regex("<td translate=\"no\">[^<]*</td>"), "");
  return std::regex_replace(std::regex_replace(kept, std::regex("<[^>]*>"), "\n"), std::regex("&[a-z]+;"),
                            " ");
}

TEST_F(ReportLanguageTest, TheJapaneseReportHasNoEnglishLeft) {
  const auto report = made("ja");
  EXPECT_THAT(englishWords(report.title + report.page_words + withoutTags(report.body)), IsEmpty());
  ASSERT_THAT(report.figures, ::testing::SizeIs(4));
  for (const auto& figure : report.figures)
    for (const auto& shape : figure.chart->shapes) EXPECT_THAT(englishWords(shape.text), IsEmpty());
  EXPECT_FALSE(englishWords(withoutTags(made("en").body)).empty()) << "the search for words finds none";
}

TEST_F(ReportLanguageTest, WhatAPersonWroteStays) {
  const auto body = made("ja").body;
  for (const char* words :
       {"no such operator", "not signed off", "<td translate=\"no\">excluded</td>", "M1, &quot;hand&quot;"})
    EXPECT_THAT(body, HasSubstr(words));
}

TEST_F(ReportLanguageTest, NumbersAndTagsAreThoseOfTheEnglishReport) {
  const auto english = made("en"), japanese = made("ja");
  const auto tags = [](const std::string& html) {
    static const std::regex kTag("<[^>]*>");
    std::vector<std::string> all;
    for (std::sregex_iterator at(html.begin(), html.end(), kTag), end; at != end; ++at)
      all.push_back(at->str());
    return all;
  };
  const auto numbers = [](const std::string& html) {
    static const std::regex kNumber("[0-9]+([.][0-9]+)?");
    const std::string text = std::regex_replace(html, std::regex("<[^>]*>"), " ");
    std::multiset<std::string> all;  // their order may change with the language
    for (std::sregex_iterator at(text.begin(), text.end(), kNumber), end; at != end; ++at)
      all.insert(at->str());
    return all;
  };
  EXPECT_EQ(tags(japanese.body), tags(english.body));
  EXPECT_EQ(numbers(japanese.body), numbers(english.body));
}

TEST_F(ReportLanguageTest, ThePageNamesItsLanguage) {
  EXPECT_THAT(toHtml(made("ja")), HasSubstr("<html lang=\"ja\">"));
  EXPECT_THAT(toHtml(made("en")), HasSubstr("<html lang=\"en\">"));
  EXPECT_THAT(report::languageCodes(), ::testing::Contains("ja"));
  EXPECT_THROW(report::languageOf("xx"), Error);
}

}  // namespace
}  // namespace facenav::steps
