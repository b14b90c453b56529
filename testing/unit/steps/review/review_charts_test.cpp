#include "facenav/report/review_charts.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "facenav/review/pulse_pictures.h"
#include "unit/case/casefile/made_pulse.h"

namespace facenav::steps {
namespace {

using ::testing::HasSubstr;

int countOf(const report::Chart& chart, report::ChartShape::Kind kind, report::Ink ink) {
  return int(std::count_if(chart.shapes.begin(), chart.shapes.end(),
                           [&](const report::ChartShape& s) { return s.kind == kind && s.ink == ink; }));
}

bool says(const report::Chart& chart, const std::string& words) {
  return std::any_of(chart.shapes.begin(), chart.shapes.end(),
                     [&](const report::ChartShape& s) { return s.text.find(words) != std::string::npos; });
}

/// Pulses 0.5, 1.0 .. 5 mm off, on target up to 2 mm; the last one excluded; one lost.
std::vector<casefile::ReviewedPulse> pulses() {
  std::vector<casefile::ReviewedPulse> given;
  for (int i = 1; i <= 10; ++i) given.push_back({casefile::madePulse(i, 0.5 * i), i == 10, {}});
  given.push_back({casefile::madeLostPulse(11), false, {}});
  return given;
}

TEST(ReviewCharts, TheDriftHasAMarkPerPulseInTheFormOfItsState) {
  const report::Chart chart = report::driftChart(pulses(), report::PulseColumn::distance);
  EXPECT_EQ(countOf(chart, report::ChartShape::Kind::disc, report::Ink::on_target), 4);
  EXPECT_EQ(countOf(chart, report::ChartShape::Kind::square, report::Ink::outside), 5);
  EXPECT_EQ(countOf(chart, report::ChartShape::Kind::cross, report::Ink::excluded), 1);
  EXPECT_TRUE(says(chart, "error (mm) over time"));
  EXPECT_TRUE(says(chart, "minutes since the first pulse"));
  const auto limit = std::find_if(chart.shapes.begin(), chart.shapes.end(),
                                  [](const report::ChartShape& s) { return s.ink == report::Ink::limit; });
  ASSERT_NE(limit, chart.shapes.end());
  int below = 0;  // further down the page
  for (const auto& s : chart.shapes) below += s.ink == report::Ink::on_target && s.y >= limit->y - 1e-9;
  EXPECT_EQ(below, 4) << "those on target lie under the line of 2 mm";
}

TEST(ReviewCharts, EveryShapeLiesInTheChart) {
  for (const report::PulseColumn column :
       {report::PulseColumn::distance, report::PulseColumn::depth, report::PulseColumn::time,
        report::PulseColumn::intensity, report::PulseColumn::mep})
    for (const report::Chart& chart :
         {report::driftChart(pulses(), column, 300, 200), report::histogramOf(pulses(), column, 300, 200)})
      for (const auto& s : chart.shapes) {
        EXPECT_GE(s.x, 0) << int(column);
        EXPECT_LE(s.x, 300) << int(column);
        EXPECT_GE(s.y, 0) << int(column);
        EXPECT_LE(s.y, 200) << int(column);
      }
}

TEST(ReviewCharts, TheHistogramsBarsAddUpToThePulsesThatCount) {
  const report::Chart chart = report::histogramOf(pulses(), report::PulseColumn::distance, 340, 260);
  double tallest = 0;
  for (const auto& s : chart.shapes)
    if (s.kind == report::ChartShape::Kind::box) tallest = std::max(tallest, s.y2);
  double sum = 0;
  for (const auto& s : chart.shapes)
    if (s.kind == report::ChartShape::Kind::box) sum += s.y2 / tallest;
  EXPECT_NEAR(sum, 9.0, 1e-6) << "one pulse a bar, the excluded and the lost one in none";
}

TEST(ReviewCharts, AColumnThatNoPulseHasIsSaid) {
  EXPECT_TRUE(says(report::driftChart(pulses(), report::PulseColumn::mep), "no pulse has: MEP"));
  EXPECT_TRUE(says(report::histogramOf(pulses(), report::PulseColumn::mep), "no pulse has: MEP"));
  EXPECT_FALSE(rangeOf(pulses(), report::PulseColumn::mep));
}

TEST(ReviewCharts, ColoursSpanThePulsesThatCount) {
  const auto range = rangeOf(pulses(), report::PulseColumn::distance);
  ASSERT_TRUE(range);
  EXPECT_DOUBLE_EQ(range->low, 0.5);
  EXPECT_DOUBLE_EQ(range->high, 4.5) << "not the excluded one";
  const auto marks = marksOf(pulses(), {}, report::PulseColumn::distance, 3);
  ASSERT_EQ(marks.size(), 10u) << "the lost one has no place";
  EXPECT_EQ(marks[0].colour, scene::sequentialColour(0));
  EXPECT_EQ(marks[8].colour, scene::sequentialColour(1));
  EXPECT_TRUE(marks[2].is_chosen && marks[9].is_excluded);
}

TEST(ReviewCharts, SvgHoldsWordsEscaped) {
  report::Chart chart;
  report::ChartShape words;
  words.kind = report::ChartShape::Kind::words;
  words.text = "a < b";
  chart.shapes = {words};
  EXPECT_THAT(report::chartSvg(chart), HasSubstr("a &lt; b"));
}

TEST(PulseColumns, NamesAreTheColumnsOfPulsesCsvAndTextHasTheUnitsDecimals) {
  const std::string header = casefile::pulsesCsv({});
  for (const auto& words : report::pulseColumns()) {
    EXPECT_THAT(header, HasSubstr(std::string(words.key)));
    EXPECT_EQ(report::wordsOf(words.column).key, words.key);
  }
  const auto pulse = casefile::madePulse(3, 1.25);
  EXPECT_EQ(report::valueText(pulse, report::PulseColumn::lateral), "1.2");
  EXPECT_EQ(report::valueText(pulse, report::PulseColumn::intensity), "55");
  EXPECT_EQ(report::valueText(pulse, report::PulseColumn::mep), "");
  EXPECT_EQ(report::valueText(casefile::madeLostPulse(1), report::PulseColumn::distance), "");
}

}  // namespace
}  // namespace facenav::steps
