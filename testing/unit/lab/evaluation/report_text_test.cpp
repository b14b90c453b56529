// CSV, Markdown, HTML and SVG with names and failures that contain separators, quotes and line breaks.

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <regex>
#include <sstream>

#include "facenav/evaluation/evaluation_report.h"
#include "facenav/evaluation/html_report.h"
#include "facenav/evaluation/mask_table.h"
#include "facenav/evaluation/run_table.h"
#include "facenav/evaluation/svg_plot.h"
#include "made_runs.h"

namespace facenav::evaluation {
namespace {

using made::perfectRun;
using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::SizeIs;

/// Cells of CSV text by RFC 4180: quotes protect commas and line breaks; two quotes are one.
std::vector<std::vector<std::string>> parsed(const std::string& csv) {
  std::vector<std::vector<std::string>> rows{{""}};
  bool is_quoted = false;
  for (std::size_t i = 0; i < csv.size(); ++i) {
    std::string& cell = rows.back().back();
    if (csv[i] == '"' && is_quoted && i + 1 < csv.size() && csv[i + 1] == '"')
      cell += csv[++i];
    else if (csv[i] == '"')
      is_quoted = !is_quoted;
    else if (csv[i] == ',' && !is_quoted)
      rows.back().emplace_back();
    else if (csv[i] == '\n' && !is_quoted)
      rows.push_back({""});
    else
      cell += csv[i];
  }
  rows.pop_back();  // after the last line break
  return rows;
}

/// Number of cells of each line of a Markdown table; "\|" is no separator.
std::vector<std::size_t> cellsPerLine(const std::string& markdown) {
  std::vector<std::size_t> counts;
  std::istringstream lines(markdown);
  for (std::string line; std::getline(lines, line);) {
    std::size_t bars = 0;
    for (std::size_t i = 0; i < line.size(); ++i) bars += line[i] == '|' && (i == 0 || line[i - 1] != '\\');
    counts.push_back(bars);
  }
  return counts;
}

TEST(RunsCsv, HasAllColumnsInEachRowWhateverTheNames) {
  RunRecord plain = perfectRun("still", 3), odd = perfectRun("tuesday, second take", 3);
  odd.head = "head, \"left\"";
  odd.rig = "rig\nb";
  odd.failure = "no face, \"really\"";
  const auto rows = parsed(runsCsv({plain, odd}));
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_THAT(rows, Each(SizeIs(rows[0].size())));
  EXPECT_EQ(rows[0][0], "scenario");
  EXPECT_EQ(rows[1][0], "still");
  EXPECT_EQ(rows[2][0], "tuesday, second take");
}

TEST(RunsCsv, ReadsBackTheFiguresThatWereMeasured) {
  RunRecord run = perfectRun("still", 4);
  run.seed = 77, run.from = "sparse dots", run.must_be_refused = true;
  run.frames[2].head_motion = made::shifted(0.25);
  const auto rows = parsed(runsCsv({run}));
  const auto figures = figuresOf(run);
  ASSERT_EQ(rows[1].size(), figures.size() + 13);
  EXPECT_EQ(rows[1][3], "77");
  EXPECT_EQ(rows[0][figures.size() + 5], "from");
  EXPECT_EQ(rows[1][figures.size() + 5], "sparse dots");
  EXPECT_EQ(rows[1][figures.size() + 6], "1");
  EXPECT_EQ(rows[0][figures.size() + 7], "right_turn_deg");
  EXPECT_EQ(rows[1][figures.size() + 7], "") << "no turn was estimated";
  run.alignment->turn_deg = 0.25, run.alignment->turn_sigma_deg = 0.125;
  const auto turned = parsed(runsCsv({run}));
  EXPECT_EQ(turned[1][figures.size() + 7], "0.25");
  EXPECT_EQ(turned[1][figures.size() + 8], "0.125");
  for (std::size_t i = 0; i < figures.size(); ++i) {
    EXPECT_EQ(rows[0][i + 5], figures[i].first);
    if (std::isfinite(figures[i].second))
      EXPECT_NEAR(std::stod(rows[1][i + 5]), figures[i].second, 1e-5 * std::abs(figures[i].second) + 1e-12);
    else
      EXPECT_EQ(rows[1][i + 5], "");
  }
}

TEST(RunsCsv, AnAlignmentThatWasRefusedIsTheFailure) {
  RunRecord run = perfectRun("capture", 0);
  run.alignment->refusal = "too little face";
  EXPECT_EQ(parsed(runsCsv({run}))[1][4], "too little face");
  run.failure = "no camera";
  EXPECT_EQ(parsed(runsCsv({run}))[1][4], "no camera");
}

TEST(MaskCsv, ReadsBackWhatWasWritten) {
  MaskRow row;
  row.volume = "a,b", row.truth = "with \"fluid\"", row.method = "two\nlines";
  row.agreement = MaskAgreement{0.9, 0.95, 1.5, 0.3, 1400, 1390};
  row.brain_ml = 1400;
  row.contrast = "T2 (fluid, bright)";
  const auto rows = parsed(maskCsv({row, MaskRow{}}));
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_THAT(rows, Each(SizeIs(rows[0].size())));
  EXPECT_EQ(rows[1][0], "a,b");
  EXPECT_EQ(rows[1][1], "with \"fluid\"");
  EXPECT_EQ(rows[1][2], "two\nlines");
  EXPECT_EQ(rows[1][3], "0.9000");
  EXPECT_EQ(rows[1][6], "95.00") << "inside, in percent";
  EXPECT_EQ(rows[1].back(), "T2 (fluid, bright)");
}

TEST(PerturbationCsv, AHardHeadNeedNotHold) {
  PerturbationRow row;
  row.moved = MaskAgreement{0.98, 1, 2, 0.2, 1, 1};
  auto rows = parsed(perturbationCsv({row}));
  EXPECT_EQ(rows[1][3], "yes");
  EXPECT_EQ(rows[1][4], "0.0200") << "1 - Dice";
  row.must_hold = false;
  rows = parsed(perturbationCsv({row}));
  EXPECT_EQ(rows[1][3], "no");
  EXPECT_EQ(rows[1][4], "");
  EXPECT_THAT(rows, Each(SizeIs(rows[0].size())));
}

TEST(Markdown, TablesKeepTheirColumnsWhateverTheNames) {
  MaskRow row;
  row.volume = "a|b", row.failure = "line one\nline two | three";
  const auto counts = cellsPerLine(maskMarkdown({row, MaskRow{}}));
  ASSERT_EQ(counts.size(), 4u);
  EXPECT_THAT(counts, Each(counts[0]));
  PerturbationRow moved;
  moved.perturbation = "x|y", moved.failure = "a\nb";
  const auto perturbed = cellsPerLine(perturbationMarkdown({moved}));
  ASSERT_EQ(perturbed.size(), 3u);
  EXPECT_THAT(perturbed, Each(perturbed[0]));
}

TEST(Markdown, GoalsAndFailuresKeepTheirColumns) {
  RunRecord run = perfectRun("still", 0);
  run.head = "a|b";
  run.failure = "first line\nsecond | line";
  const std::string text = goalsMarkdown({run});
  const auto at = text.find("| run | why |");
  ASSERT_NE(at, std::string::npos);
  const auto counts = cellsPerLine(text.substr(at));
  ASSERT_EQ(counts.size(), 3u) << text.substr(at);
  EXPECT_THAT(counts, Each(3u));
}

TEST(HtmlReport, NoTextBecomesMarkup) {
  const std::string evil = "<script>alert('x')</script> & \"q\"";
  const std::string html =
      htmlReport(evil, evil, {{evil, evil, {{evil, {evil}, {{evil}}}}, {{evil, "p\" onerror=\"x.png"}}}});
  EXPECT_THAT(html, Not(HasSubstr("<script")));
  EXPECT_THAT(html, Not(HasSubstr("\" onerror")));
  EXPECT_THAT(html, Not(HasSubstr("http")));
  std::size_t escaped = 0;
  for (auto at = html.find("&lt;script&gt;"); at != std::string::npos;
       at = html.find("&lt;script&gt;", at + 1))
    ++escaped;
  EXPECT_EQ(escaped, 10u)
      << "title twice, subtitle, heading, text, table heading, column, cell, caption twice";
}

TEST(HtmlReport, ShowsPicturesVideosAndLinksByTheirEnding) {
  const auto figure = [](const std::string& file) {
    return htmlReport("t", "", {{"", "", {}, {{"c", file}}}});
  };
  EXPECT_THAT(figure("a.svg"), HasSubstr("<img src=\"a.svg\""));
  EXPECT_THAT(figure("a.webm"), HasSubstr("<video"));
  EXPECT_THAT(figure("a.avi"), HasSubstr("<a href=\"a.avi\""));
}

/// All numbers in attributes of this name of the elements of this kind.
std::vector<double> attributes(const std::string& svg, const std::string& element, const std::string& name) {
  std::vector<double> values;
  const std::regex pattern("<" + element + "[^>]*\\b" + name + "='([-0-9.e]+)'");
  for (std::sregex_iterator it(svg.begin(), svg.end(), pattern), end; it != end; ++it)
    values.push_back(std::stod((*it)[1]));
  return values;
}

TEST(SvgPlot, LargerValuesAreHigherAndFartherRight) {
  const std::string svg = svgPlot({"t", "x", "y"}, {{"marks", {{0, 1}, {2, 5}, {4, 3}}, false}});
  const auto x = attributes(svg, "circle", "cx"), y = attributes(svg, "circle", "cy");
  ASSERT_EQ(x.size(), 3u);
  EXPECT_LT(x[0], x[1]);
  EXPECT_NEAR(x[2] - x[1], x[1] - x[0], 0.02) << "a linear axis";
  EXPECT_LT(y[1], y[2]);
  EXPECT_LT(y[2], y[0]);
  EXPECT_NEAR(y[0] - y[2], y[2] - y[1], 0.02);
}

TEST(SvgPlot, StaysInsideItsFrameForAnyValues) {
  std::vector<std::pair<double, double>> points;
  for (const double v : {-1e6, -3.0, 0.0, 1e-9, 42.0, 1e7}) points.emplace_back(v, -v);
  points.emplace_back(std::nan(""), 1.0);
  points.emplace_back(1.0, std::numeric_limits<double>::infinity());
  const std::string svg =
      svgPlot({"t", "x", "y"}, {{"wild", points, false}, {"constant", {{0, 5}, {1, 5}}, false}});
  const auto x = attributes(svg, "circle", "cx"), y = attributes(svg, "circle", "cy");
  EXPECT_EQ(x.size(), 8u) << "points that are not finite are left out";
  for (const double value : x) EXPECT_TRUE(value >= 0 && value <= 720) << value;
  for (const double value : y) EXPECT_TRUE(value >= 0 && value <= 400) << value;
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
  EXPECT_THAT(svg, Not(HasSubstr("inf")));
}

}  // namespace
}  // namespace facenav::evaluation
