#include "facenav/core/plain_words.h"

#include <gtest/gtest.h>

#include "facenav/core/error.h"

namespace facenav {
namespace {

TEST(PlainWords, TakesNamesOfEveryScript) {
  for (const char* name : {"M1 hand L", "über \"Mitte\"", "왼손 운동피질", "左手", "😀"})
    EXPECT_EQ(faultOfWords(name, kLongestName), "") << name;
  EXPECT_NO_THROW(requireName("C3'", "the target's name"));
}

TEST(PlainWords, RefusesControlCharactersTurnedTextAndWrongBytes) {
  for (const std::string& text : {std::string("a\nb"), std::string("a\tb"), std::string("a\x1b[31mb"),
                                  std::string("a\0b", 3), std::string("a\x7f"), std::string("\xC2\x85"),
                                  std::string("\xE2\x80\xA8"), std::string("left\xE2\x80\xAEright")})
    EXPECT_NE(faultOfWords(text, kLongestName), "") << text;
  for (const std::string& text :
       {std::string("\xFF"), std::string("\xC3"), std::string("\xE2\x82"), std::string("\xC0\x80"),
        std::string("\xED\xA0\x80"), std::string("M\xFCller")})
    EXPECT_NE(faultOfWords(text, kLongestName).find("UTF-8"), std::string::npos) << text;
}

TEST(PlainWords, ANoteMayHaveLinesAndAnEndToItsLength) {
  EXPECT_NO_THROW(requireNote("first\nsecond\tline", "the note"));
  EXPECT_THROW(requireNote("bell \a", "the note"), Error);
  EXPECT_THROW(requireNote(std::string(kLongestNote + 1, 'x'), "the note"), Error);
}

TEST(PlainWords, ANameIsOneLineOfSomeLength) {
  EXPECT_NO_THROW(requireName(std::string(kLongestName, 'x'), "the name"));
  for (const std::string& name : {std::string(), std::string("  "), std::string(kLongestName + 1, 'x')})
    EXPECT_THROW(requireName(name, "the name"), Error) << name;
}

}  // namespace
}  // namespace facenav
