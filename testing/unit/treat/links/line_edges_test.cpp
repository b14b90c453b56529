#include "line_edges.h"

#include <gtest/gtest.h>

#include <random>

namespace facenav::links {
namespace {

TEST(LineEdges, TheCountFindsPulsesBetweenTwoReadings) {
  EXPECT_EQ(risingEdges({false, 10}, {false, 12}), 1) << "up and down again";
  EXPECT_EQ(risingEdges({false, 10}, {true, 11}), 1);
  EXPECT_EQ(risingEdges({true, 11}, {false, 12}), 0) << "the end of a pulse is none";
  EXPECT_EQ(risingEdges({true, 11}, {true, 15}), 2);
  EXPECT_EQ(risingEdges({false, 12}, {false, 12}), 0);
}

TEST(LineEdges, WithoutACountTheLevelDecides) {
  EXPECT_EQ(risingEdges({false, {}}, {true, {}}), 1);
  EXPECT_EQ(risingEdges({true, {}}, {true, {}}), 0);
  EXPECT_EQ(risingEdges({true, {}}, {false, {}}), 0);
}

TEST(LineEdges, NoPulseOfALongTrainIsLostOrDoubledWhateverTheReadings) {
  std::mt19937 random(4);
  std::bernoulli_distribution is_read(0.3);
  LineReading line{false, 0}, last = line;
  int pulses = 0, counted = 0;
  for (int change = 0; change < 20001; ++change) {
    line.is_high = !line.is_high;
    ++*line.changes;
    pulses += line.is_high;
    if (!is_read(random)) continue;
    counted += risingEdges(last, line);
    last = line;
  }
  counted += risingEdges(last, line);
  EXPECT_EQ(counted, pulses);
}

}  // namespace
}  // namespace facenav::links
