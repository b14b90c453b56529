#pragma once
// What torch gives for the test's pattern: made by resources/training/brain_prior/expected.py.

namespace facenav::segmentation {

struct ExpectedShares {
  int i, j, k;
  float share[4];
};
constexpr ExpectedShares kExpectedByTorch[] = {
    {0, 0, 0, {0.999916f, 0.000016f, 0.000012f, 0.000056f}},
    {24, 28, 24, {0.001688f, 0.948473f, 0.047200f, 0.002639f}},
    {25, 28, 24, {0.001657f, 0.942112f, 0.052360f, 0.003871f}},
    {24, 29, 24, {0.002839f, 0.917377f, 0.071325f, 0.008458f}},
    {24, 28, 25, {0.000730f, 0.963918f, 0.034254f, 0.001099f}},
    {47, 55, 47, {0.999993f, 0.000001f, 0.000000f, 0.000006f}},
    {10, 40, 33, {0.057399f, 0.608110f, 0.207908f, 0.126583f}},
    {37, 5, 12, {1.000000f, 0.000000f, 0.000000f, 0.000000f}},
};

}  // namespace facenav::segmentation
