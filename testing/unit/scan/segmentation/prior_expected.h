#pragma once
// Torch's results for the test's pattern, made by resources/training/brain_prior/expected.py.

namespace facenav::segmentation {

struct ExpectedShares {
  int i, j, k;
  float share[4];
};
constexpr ExpectedShares kExpectedByTorch[] = {
    {0, 0, 0, {0.999986f, 0.000000f, 0.000001f, 0.000012f}},
    {24, 28, 24, {0.999999f, 0.000000f, 0.000000f, 0.000001f}},
    {25, 28, 24, {0.999998f, 0.000000f, 0.000000f, 0.000002f}},
    {24, 29, 24, {0.999999f, 0.000000f, 0.000000f, 0.000001f}},
    {24, 28, 25, {0.999987f, 0.000000f, 0.000000f, 0.000013f}},
    {47, 55, 47, {1.000000f, 0.000000f, 0.000000f, 0.000000f}},
    {10, 40, 33, {0.006319f, 0.000017f, 0.000030f, 0.993634f}},
    {37, 5, 12, {0.000001f, 0.999836f, 0.000163f, 0.000000f}},
};

}  // namespace facenav::segmentation
