// Products and factorisations of module efield against Eigen's, and both sets of inner loops.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "dense/lu.h"
#include "dense/product.h"
#include "facenav/core/error.h"
#include "facenav/core/simd.h"
#include "kernels/field_kernel.h"
#include "support/refusal.h"

namespace facenav::efield::dense {
namespace {

using facenav::testing::refusalOf;

Eigen::MatrixXf randomMatrix(Eigen::Index rows, Eigen::Index columns, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> value(-1, 1);
  return Eigen::MatrixXf::NullaryExpr(rows, columns, [&] { return value(random); });
}

TEST(Product, IsThatOfEigenForAnySizeAndForTransposedMatrices) {
  for (const auto& [m, n, k] : {std::array{1, 1, 1}, std::array{37, 11, 5}, std::array{200, 403, 900}}) {
    const Eigen::MatrixXf a = randomMatrix(m, k, 1), b = randomMatrix(k, n, 2), start = randomMatrix(m, n, 3);
    const Eigen::MatrixXf a_turned = a.transpose(), b_turned = b.transpose();
    Eigen::MatrixXf plain = start, turned = start;
    addProduct(viewOf(plain), -2.f, viewOf(a), viewOf(b));
    addProduct(viewOf(turned), -2.f, viewOf(a_turned).transposed(), viewOf(b_turned).transposed());
    const Eigen::MatrixXd truth = start.cast<double>() - 2 * a.cast<double>() * b.cast<double>();
    EXPECT_LT((plain.cast<double>() - truth).cwiseAbs().maxCoeff(), 1e-6 * k + 1e-6);
    EXPECT_LT((turned.cast<double>() - truth).cwiseAbs().maxCoeff(), 1e-6 * k + 1e-6);
  }
}

TEST(Lu, SolvesBothWaysAndExchangesRows) {
  for (const int size : {1, 16, 17, 150, 403}) {
    const Eigen::MatrixXf a = randomMatrix(size, size, 4), truth = randomMatrix(size, 5, 5);
    Eigen::MatrixXf lu = a, x = a * truth, y = a.transpose() * truth;
    const Pivots pivots = factorise(viewOf(lu));
    solve(viewOf(lu), pivots, viewOf(x));
    solveTransposed(viewOf(lu), pivots, viewOf(y));
    EXPECT_LT((x - truth).norm() / truth.norm(), 2e-3) << size;
    EXPECT_LT((y - truth).norm() / truth.norm(), 2e-3) << size;
    EXPECT_LT((a * x - a * truth).norm() / (a * truth).norm(), 1e-4) << size;
  }
}

TEST(Lu, ReportsItsProgressAndCanBeEnded) {
  Eigen::MatrixXf lu = randomMatrix(600, 600, 6);
  const Eigen::MatrixXf a = lu;
  std::vector<double> shares;
  factorise(viewOf(lu), [&](double share) { shares.push_back(share); });
  ASSERT_GE(shares.size(), 5u);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_GT(shares.back(), 0.95);
  EXPECT_LE(shares.back(), 1.0);
  lu = a;
  const auto endAtHalf = [](double share) {
    if (share > 0.5) throw Error("ended");
  };
  EXPECT_EQ(refusalOf([&] { factorise(viewOf(lu), endAtHalf); }), "ended");
}

TEST(Lu, RefusesASingularMatrix) {
  Eigen::MatrixXf a = Eigen::MatrixXf::Zero(20, 20);
  EXPECT_NE(facenav::testing::refusalOf([&] { factorise(viewOf(a)); }), "");
}

TEST(FieldKernel, BothInstructionSetsAgree) {
  if (instructionSet() != InstructionSet::avx2) GTEST_SKIP() << "this processor has no AVX2";
  using namespace kernels;
  const Eigen::MatrixXf places = 50 * randomMatrix(32, 3, 6), dipoles = randomMatrix(3, 7, 7);
  const Eigen::MatrixXf positions = 100 * dipoles;
  Eigen::MatrixXf found[2] = {Eigen::MatrixXf(32, 3), Eigen::MatrixXf(32, 3)};
  const Kernel sets[2] = {baseKernel(), avx2Kernel()};
  for (int set = 0; set < 2; ++set)
    sets[set].dipoles({{places.col(0).data(), places.col(1).data(), places.col(2).data(), 32},
                       positions.data(),
                       dipoles.data(),
                       7,
                       found[set].col(0).data(),
                       found[set].col(1).data(),
                       found[set].col(2).data()});
  EXPECT_LT((found[0] - found[1]).norm(), 1e-5 * found[0].norm());
}

}  // namespace
}  // namespace facenav::efield::dense
