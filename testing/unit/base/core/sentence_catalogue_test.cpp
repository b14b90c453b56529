// Sentences in another language: how a composed text finds its translation, and that every sentence of the
// real catalogue does.

#include "facenav/core/sentence_catalogue.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <regex>

#include "facenav/core/error.h"

namespace facenav {
namespace {

const char* const kCatalogue =
    R"(<?xml version="1.0" encoding="utf-8"?><!DOCTYPE TS><TS version="2.1" language="de">
<context><name>core</name>
<message><source>the head moved by %1 mm and %2 deg</source><translation>Kopf um %2 Grad und %1 mm bewegt</translation></message>
<message><source>hold the head still</source><translation>Kopf still halten</translation></message>
<message><source>not aligned</source><translation>nicht ausgerichtet</translation></message>
<message><source>no picture was taken: %1</source><translation>kein Bild: %1</translation></message>
<message><source>%1 is empty</source><translation>%1 ist leer</translation></message>
<message><source>not finished</source><translation type="unfinished">X</translation></message>
</context>
<context><name>other</name><message><source>two words</source><translation>X</translation></message></context></TS>)";

std::string german(const std::string& words) {
  const SentenceCatalogue sentences(kCatalogue, {"core"});
  EXPECT_EQ(sentences.count(), 5u);
  EXPECT_EQ(sentences.language(), "de");
  return sentences.translated(words);
}

TEST(SentenceCatalogue, ValuesMoveToTheirPlacesInTheTranslation) {
  EXPECT_EQ(german("the head moved by 3.5 mm and 2 deg"), "Kopf um 2 Grad und 3.5 mm bewegt");
}

TEST(SentenceCatalogue, EachSentenceOfATextIsTranslatedAndWhatJoinsThemStays) {
  EXPECT_EQ(german("not aligned: the head moved by 3.5 mm and 2 deg; hold the head still."),
            "nicht ausgerichtet: Kopf um 2 Grad und 3.5 mm bewegt; Kopf still halten.");
  EXPECT_EQ(german("/tmp/a.yml: hold the head still (not aligned)"),
            "/tmp/a.yml: Kopf still halten (nicht ausgerichtet)");
}

TEST(SentenceCatalogue, ASentenceInAnotherIsTranslatedToo) {
  EXPECT_EQ(german("no picture was taken: hold the head still"), "kein Bild: Kopf still halten");
}

TEST(SentenceCatalogue, WhatTheCatalogueLacksStaysAsItIs) {
  for (const char* words : {"", "a new sentence", "not finished", "two words", "hold the head still now",
                            "the head moved by 3.5 mm"})
    EXPECT_EQ(german(words), words);
  EXPECT_EQ(german("a new sentence; hold the head still"), "a new sentence; Kopf still halten");
}

TEST(SentenceCatalogue, ATitleIsTranslatedAlone) {
  const SentenceCatalogue sentences(R"(<TS language="de"><context><name>core</name><message>
<source>FACE HIDDEN: move &quot;it&quot; &amp; wait</source><translation>GESICHT VERDECKT: &lt;weg&gt;</translation></message></context></TS>)",
                                    {"core"});
  EXPECT_EQ(sentences.translated("left   FACE HIDDEN"), "left   GESICHT VERDECKT");
  EXPECT_EQ(sentences.translated("face hidden"), "GESICHT VERDECKT");
  EXPECT_EQ(sentences.translated("FACE HIDDEN: move \"it\" & wait"), "GESICHT VERDECKT: <weg>");
}

struct Message {
  std::string source, translation;
};

std::string withoutEntities(std::string text) {
  const std::pair<const char*, const char*> letters[] = {
      {"&apos;", "'"}, {"&quot;", "\""}, {"&lt;", "<"}, {"&gt;", ">"}, {"&amp;", "&"}};
  for (const auto& [entity, letter] : letters) text = std::regex_replace(text, std::regex(entity), letter);
  return text;
}

/// The messages of a context, read line by line as lupdate writes them: not by the code under test.
std::vector<Message> messagesOf(const std::string& ts, const std::string& context) {
  static const std::regex kName("<name>(.*)</name>"), kSource("<source>(.*)</source>"),
      kTranslation("<translation>(.*)</translation>");
  std::vector<Message> found;
  std::istringstream lines(ts);
  std::string name, source;
  std::smatch part;
  for (std::string line; std::getline(lines, line);) {
    if (std::regex_search(line, part, kName)) name = part[1];
    if (std::regex_search(line, part, kSource)) source = part[1];
    if (name == context && std::regex_search(line, part, kTranslation))
      found.push_back({withoutEntities(source), withoutEntities(part[1])});
  }
  return found;
}

/// The text with a number of one decimal for each value: 1.5 for %1, 2.5 for %2.
std::string filledIn(const std::string& text) {
  static const std::regex kValue("%([0-9])");
  return std::regex_replace(text, kValue, "$1.5");
}

std::string japanese() {
  std::ifstream file(FACENAV_SOURCE_DIR "/resources/languages/facenav_ja.ts");
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(JapaneseSentences, EachIsFoundWithNumbersInIt) {
  const std::string ts = japanese();
  const SentenceCatalogue sentences(ts, {"core"});
  const auto messages = messagesOf(ts, "core");
  ASSERT_GT(messages.size(), 2000u);
  EXPECT_EQ(messages.size(), sentences.count());
  for (const auto& [source, translation] : messages)
    EXPECT_EQ(sentences.translated(filledIn(source)), filledIn(translation)) << source;
}

// A refusal reaches the window in three parts: where, what happened, what to do.
TEST(JapaneseSentences, EachIsFoundInARefusalToo) {
  const std::string ts = japanese(), remedy = "use a scan of the whole head";
  const SentenceCatalogue sentences(ts, {"core"});
  const std::string shown_remedy = sentences.translated(remedy);
  ASSERT_NE(shown_remedy, remedy);
  for (const auto& [source, translation] : messagesOf(ts, "core")) {
    const Error error(filledIn(source), "case.json", remedy),
        expected(filledIn(translation), "case.json", shown_remedy);
    EXPECT_EQ(sentences.translated(error.what()), expected.what()) << source;
  }
}

}  // namespace
}  // namespace facenav
