#include "facenav/stimulation/threshold.h"

#include <gmock/gmock.h>

#include <cmath>

#include "facenav/core/error.h"
#include "facenav/core/robust_statistics.h"
#include "support/virtual_subject.h"

namespace facenav::stimulation {
namespace {

using ::testing::HasSubstr;

constexpr auto kBayes = ThresholdMethod::bayes, kRule = ThresholdMethod::five_of_ten;

/// Searches with answers of a muscle that always responds from `threshold_pct` on.
ThresholdState searchSharp(ThresholdMethod method, double threshold_pct) {
  std::vector<ThresholdAnswer> answers;
  auto state = thresholdAfter(method, answers);
  while (!state.isDone() && answers.size() < 500) {
    answers.push_back({*state.next_pct, *state.next_pct >= threshold_pct});
    state = thresholdAfter(method, answers);
  }
  return state;
}

TEST(Threshold, BayesBeginsAtThePriorMeanWithThePriorsInterval) {
  const auto state = thresholdAfter(kBayes, {});
  EXPECT_DOUBLE_EQ(state.next_pct.value(), 52);
  EXPECT_NEAR(*state.estimate_pct, 52, 0.05);
  EXPECT_NEAR((*state.interval_pct)[0], 52 - 1.3 * 1.96 * 14, 0.2);
  EXPECT_NEAR((*state.interval_pct)[1], 52 + 1.3 * 1.96 * 14, 0.2);
}

TEST(Threshold, OneAnswerMovesBayesAsTheIntegralSays) {
  // Computed independently of the grid: Simpson's rule over prior times response curve.
  const auto density = [](double t) {
    const double z = (t - 52) / 14;
    return std::exp(-0.5 * z * z) * 0.5 * std::erfc(-(52 - t) / (0.07 * t) * M_SQRT1_2);
  };
  double sum = 0, moment = 0;
  const int steps = 200000;
  for (int i = 0; i <= steps; ++i) {
    const double t = 1 + 149.0 * i / steps, weight = i == 0 || i == steps ? 1 : i % 2 ? 4 : 2;
    sum += weight * density(t), moment += weight * t * density(t);
  }
  EXPECT_NEAR(*thresholdAfter(kBayes, {{52, true}}).estimate_pct, moment / sum, 0.01);
}

TEST(Threshold, BothFindASharpThreshold) {
  for (const double threshold_pct : {33.0, 47.0, 52.0, 68.0, 90.0}) {
    EXPECT_NEAR(*searchSharp(kBayes, threshold_pct).estimate_pct, threshold_pct - 0.5, 2.0);
    EXPECT_DOUBLE_EQ(*searchSharp(kRule, threshold_pct).estimate_pct, threshold_pct);
  }
}

TEST(Threshold, AMuscleThatNeverRespondsHasNoThreshold) {
  for (const auto method : {kBayes, kRule}) {
    const auto state = searchSharp(method, 1000);
    EXPECT_TRUE(state.isDone());
    EXPECT_TRUE(state.is_above_output) << toString(method);
    EXPECT_THAT(inWords(state, method), HasSubstr("not found up to 100 %"));
  }
}

TEST(Threshold, AMuscleThatAlwaysRespondsEndsAtTheBottom) {
  EXPECT_DOUBLE_EQ(*searchSharp(kRule, 0).estimate_pct, 1);
  EXPECT_TRUE(searchSharp(kBayes, 0).isDone());
}

TEST(Threshold, FiveOfTenCountsAsTheRuleSays) {
  std::vector<ThresholdAnswer> answers{{35, false}, {40, true}, {40, false}};
  EXPECT_DOUBLE_EQ(*thresholdAfter(kRule, answers).next_pct, 45) << "one miss on the way up";
  for (int i = 0; i < 3; ++i) answers.push_back({45, true});
  EXPECT_DOUBLE_EQ(*thresholdAfter(kRule, answers).next_pct, 44);
  for (int i = 0; i < 5; ++i) answers.push_back({44, false});
  for (int i = 0; i < 5; ++i) answers.push_back({44, true});
  auto state = thresholdAfter(kRule, answers);
  EXPECT_DOUBLE_EQ(*state.next_pct, 43) << "5 of 10 are enough";
  answers.push_back({60, true});
  EXPECT_THAT(thresholdAfter(kRule, answers).level, HasSubstr("0 with a response, 0 without"))
      << "another intensity says nothing of this level";
  for (int i = 0; i < 4; ++i) answers.push_back({43, true});
  for (int i = 0; i < 6; ++i) answers.push_back({43, false});
  state = thresholdAfter(kRule, answers);
  EXPECT_TRUE(state.isDone());
  EXPECT_DOUBLE_EQ(*state.estimate_pct, 44);
  EXPECT_EQ(state.pulses, 27);
}

TEST(Threshold, ContraryAnswersLeaveBayesUncertainAndFinite) {
  std::vector<ThresholdAnswer> answers;
  for (int i = 0; i < 5; ++i) answers.push_back({20, true}), answers.push_back({95, false});
  const auto state = thresholdAfter(kBayes, answers);
  EXPECT_TRUE(std::isfinite(*state.estimate_pct));
  EXPECT_GT(*state.estimate_pct, 1);
  EXPECT_LT(*state.estimate_pct, 150);
}

TEST(Threshold, AnImpossibleIntensityIsRefused) {
  EXPECT_THROW(thresholdAfter(kBayes, {{120, true}}), Error);
  EXPECT_THROW(thresholdAfter(kBayes, {{std::nan(""), true}}), Error);
  EXPECT_THROW(thresholdMethodFrom("guess"), Error);
}

struct Outcome {
  std::vector<double> error_pct, pulses;
  int inside = 0;  // the interval contains the truth
};

Outcome searchSubjects(ThresholdMethod method, int subjects, unsigned seed = 20261123) {
  Outcome outcome;
  std::mt19937_64 random(seed);
  for (int i = 0; i < subjects; ++i) {
    const testing::VirtualSubject subject = testing::drawSubject(random);
    const double truth_pct = testing::trueThreshold_pct(subject);
    std::vector<ThresholdAnswer> answers;
    auto state = thresholdAfter(method, answers);
    while (!state.isDone()) {
      answers.push_back({*state.next_pct, testing::drawMep_uv(subject, *state.next_pct, random) >= 50});
      state = thresholdAfter(method, answers);
    }
    outcome.error_pct.push_back(std::abs(state.estimate_pct.value_or(100) - truth_pct));
    outcome.pulses.push_back(state.pulses);
    if (state.interval_pct)
      outcome.inside += (*state.interval_pct)[0] <= truth_pct && truth_pct <= (*state.interval_pct)[1];
  }
  return outcome;
}

TEST(Threshold, BayesIsWithinTwoPercentOfOutputOnVirtualSubjectsInTwentyPulses) {
  const Outcome outcome = searchSubjects(kBayes, 200);
  std::printf(
      "bayes on 200 subjects: error median %.2f, p95 %.2f %% of output; pulses median %.0f; 95 %% "
      "interval holds the truth in %d\n",
      median(outcome.error_pct), valueAtRank(outcome.error_pct, 189), median(outcome.pulses), outcome.inside);
  EXPECT_LE(median(outcome.error_pct), 2.0);
  for (const double pulses : outcome.pulses) EXPECT_LE(pulses, 20);
}

TEST(Threshold, TheStatedIntervalHoldsTheTruthInNineteenOfTwenty) {
  // Subjects of another seed than those of the fit (1). 95 % of 1000: standard deviation 0.7 %.
  const Outcome outcome = searchSubjects(kBayes, 1000, 3);
  std::printf("the 95 %% interval holds the truth in %d of 1000\n", outcome.inside);
  EXPECT_GE(outcome.inside, 930);
  EXPECT_LE(outcome.inside, 975);
}

TEST(Threshold, FiveOfTenTakesManyMorePulsesForNoSmallerAnError) {
  const Outcome outcome = searchSubjects(kRule, 200);
  std::printf("5of10 on 200 subjects: error median %.2f, p95 %.2f %% of output; pulses median %.0f\n",
              median(outcome.error_pct), valueAtRank(outcome.error_pct, 189), median(outcome.pulses));
  EXPECT_GT(median(outcome.pulses), 30);
  EXPECT_LE(median(outcome.error_pct), 5.0);
}

}  // namespace
}  // namespace facenav::stimulation
