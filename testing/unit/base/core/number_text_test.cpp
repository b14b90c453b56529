#include "facenav/core/number_text.h"

#include <gtest/gtest.h>

#include <clocale>
#include <limits>

#include "facenav/core/error.h"

namespace facenav {
namespace {

TEST(NumberText, FixedRoundsToTheDecimalsAsked) {
  EXPECT_EQ(fixed(3.14159, 2), "3.14");
  EXPECT_EQ(fixed(-0.5, 0), "-0");
  EXPECT_EQ(fixed(12, 3), "12.000");
  EXPECT_EQ(fixed(std::numeric_limits<double>::max(), 0).size(), 309u);
}

TEST(NumberText, FormattedWritesAsPrintfAtAnyLength) {
  EXPECT_EQ(formatted("%s: %.1f mm, %d of %zu", "coil", 1.25, 3, std::size_t(4)), "coil: 1.2 mm, 3 of 4");
  EXPECT_EQ(formatted("%%"), "%");
  const std::string word(1000, 'x');
  EXPECT_EQ(formatted("%s|", word.c_str()), word + "|");
}

TEST(NumberText, AgreesWithPrintf) {
  for (const double value : {0.0, 0.05, 0.15, 2.5, 1e15 / 3, -7.125, 1e-9}) {
    char text[64];
    std::snprintf(text, sizeof text, "%.3f", value);
    EXPECT_EQ(fixed(value, 3), text);
  }
}

TEST(NumberText, HasAPointInEveryLocale) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8"}) std::setlocale(LC_ALL, name);  // where installed
  EXPECT_EQ(formatted("%.1f", 0.5), "0.5");
  EXPECT_EQ(fixed(0.5, 1), "0.5");
  std::setlocale(LC_ALL, before.c_str());
}

TEST(NumberText, ReadsWholeFiniteNumbersOnly) {
  EXPECT_EQ(numberIn("-38.5"), -38.5);
  EXPECT_EQ(numberIn("+45"), 45.0);
  EXPECT_EQ(numberIn("1.7e15"), 1.7e15);  // microseconds since 1970
  for (const char* text : {"", "nan", "NaN", "inf", "-inf", "infinity", "1e30", "-1e17", "1e999", "5 mm",
                           "1,5", "0x10", "+", "--1", " 1", "1 "})
    EXPECT_FALSE(numberIn(text)) << text;
}

TEST(NumberText, ReadsListsWithoutAGap) {
  EXPECT_EQ(numbersIn("1.5,-20,3"), (std::vector<double>{1.5, -20, 3}));
  for (const char* text : {"", "1,", ",1", "1,,2", "1,nan,3", "1 2 3"})
    EXPECT_TRUE(numbersIn(text).empty()) << text;
}

}  // namespace
}  // namespace facenav
