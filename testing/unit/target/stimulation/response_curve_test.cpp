#include "facenav/stimulation/response_curve.h"

#include <gtest/gtest.h>

#include <random>

#include "facenav/core/error.h"

namespace facenav::stimulation {
namespace {

/// Fields evenly from `low` to `high`, and their responses with scatter.
template <class Curve>
ResponseCurve fitted(double low, double high, int pulses, double scatter, Curve curve) {
  std::mt19937 random(11);
  std::normal_distribution<double> noise(0, scatter);
  Eigen::VectorXd field(pulses), response(pulses);
  for (int i = 0; i < pulses; ++i) {
    field[i] = low + (high - low) * i / (pulses - 1);
    response[i] = curve(field[i]) + noise(random);
  }
  return fitResponse(field, response);
}

TEST(ResponseCurve, AKnownSigmoidComesBack) {
  const Sigmoid truth{1.2, 2.0, 0.9, 0.06};
  const auto curve = fitted(0.5, 1.4, 80, 1e-9, [&](double x) { return truth.at(x); });
  EXPECT_EQ(curve.verdict, CurveVerdict::sigmoid);
  EXPECT_NEAR(curve.sigmoid.midpoint, 0.9, 1e-3);
  EXPECT_NEAR(curve.sigmoid.width, 0.06, 1e-3);
  EXPECT_NEAR(curve.sigmoid.low, 1.2, 5e-3);
  EXPECT_NEAR(curve.sigmoid.height, 2.0, 1e-2);
  EXPECT_GT(curve.r2_sigmoid, 0.9999);
  EXPECT_GT(curve.aicc_gain, 100);
}

TEST(ResponseCurve, AScatteredSigmoidIsToldFromALine) {
  const Sigmoid truth{1.2, 2.0, 0.9, 0.06};
  const auto curve = fitted(0.5, 1.4, 60, 0.2, [&](double x) { return truth.at(x); });
  EXPECT_EQ(curve.verdict, CurveVerdict::sigmoid);
  EXPECT_NEAR(curve.sigmoid.midpoint, 0.9, 0.03);
}

TEST(ResponseCurve, ALineStaysALineAndHasNoMidpoint) {
  const auto curve = fitted(0.5, 1.4, 60, 0.2, [](double x) { return 1 + 2 * x; });
  EXPECT_EQ(curve.verdict, CurveVerdict::line);
  EXPECT_LE(curve.aicc_gain, kLeastGain);
  EXPECT_NEAR(curve.slope, 2, 0.3);
  EXPECT_GT(curve.r2_line, 0.8);
  EXPECT_EQ(fitted(0.5, 1.4, 40, 0.2, [](double) { return 3.0; }).verdict, CurveVerdict::line);
  EXPECT_EQ(fitted(0.5, 1.4, 40, 0.1, [](double x) { return 3 - x; }).verdict, CurveVerdict::line);
}

TEST(ResponseCurve, OneSideOfTheBendGivesNoMidpoint) {
  const Sigmoid truth{1.2, 2.0, 1.4, 0.05};  // the rise begins where the fields end
  const auto curve = fitted(0.5, 1.4, 60, 0.02, [&](double x) { return truth.at(x); });
  EXPECT_EQ(curve.verdict, CurveVerdict::no_bend);
}

TEST(ResponseCurve, IsTheSameEachTimeAndRefusesTooLittle) {
  const Sigmoid truth{0, 1, 1, 0.1};
  const auto fit = [&] { return fitted(0.5, 1.5, 50, 0.1, [&](double x) { return truth.at(x); }); };
  EXPECT_EQ(fit().sigmoid.midpoint, fit().sigmoid.midpoint);
  EXPECT_THROW(fitResponse(Eigen::VectorXd::LinSpaced(5, 0, 1), Eigen::VectorXd::Ones(5)), Error);
  EXPECT_THROW(fitResponse(Eigen::VectorXd::Ones(20), Eigen::VectorXd::LinSpaced(20, 0, 1)), Error);
}

}  // namespace
}  // namespace facenav::stimulation
