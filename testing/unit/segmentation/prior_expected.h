#pragma once
// What torch gives for the test's pattern: made by resources/training/brain_prior/expected.py.

namespace facenav::segmentation {

struct ExpectedShares {
  int i, j, k;
  float share[4];
};
constexpr ExpectedShares kExpectedByTorch[] = {
    {0, 0, 0, {0.999956f, 0.000009f, 0.000007f, 0.000028f}},
    {24, 28, 24, {0.003157f, 0.924153f, 0.066592f, 0.006099f}},
    {25, 28, 24, {0.003039f, 0.917995f, 0.069906f, 0.009059f}},
    {24, 29, 24, {0.004334f, 0.894320f, 0.087255f, 0.014091f}},
    {24, 28, 25, {0.001828f, 0.946397f, 0.048867f, 0.002907f}},
    {47, 55, 47, {0.999996f, 0.000000f, 0.000000f, 0.000003f}},
    {10, 40, 33, {0.039080f, 0.693973f, 0.187457f, 0.079490f}},
    {37, 5, 12, {1.000000f, 0.000000f, 0.000000f, 0.000000f}},
};

}  // namespace facenav::segmentation
