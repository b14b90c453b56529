#pragma once
// VirtualSubject: a person whose MEPs are drawn from a published statistical model, to test searches for the
// motor threshold on. Written from the equations and population parameters of Goetz, Alavi, Deng, Peterchev
// 2019, Statistical Model of Motor-Evoked Potentials, IEEE Trans Neural Syst Rehabil Eng 27(8): 1539-1545
// (preprint doi 10.1101/406777):
//   V = n + 10^(-7 + y + plateau / (1 + half / (x - onset + e)^steepness))   volt, x: intensity in % of
//   output
// with e normal (the excitability varies), y normal (the pathway varies) and n of a generalised extreme value
// distribution (noise of the recording). Below onset there is no evoked part.

#include <random>

namespace facenav::testing {

struct VirtualSubject {
  double plateau = 0, half = 0, steepness = 0, onset_pct = 0;  // of the recruitment curve; plateau in decades
  double excitability_spread_pct = 0;                          // standard deviation of e
  double pathway_spread = 0;                                   // standard deviation of y, decades
  double noise_v = 0, noise_scale_v = 0, noise_shape = 0;      // location, scale and shape of n
};

/// From the population's distributions; subjects whose curve does not rise from noise to a large MEP between
/// 20 and 120 % are drawn again, as in the article, and so are thresholds outside 30 to 100 %, as in Wang,
/// Peterchev, Goetz 2023 (a stimulator cannot measure them).
VirtualSubject drawSubject(std::mt19937_64& random);

/// Peak-to-peak amplitude of one MEP, uV.
double drawMep_uv(const VirtualSubject& subject, double intensity_pct, std::mt19937_64& random);

/// Probability of an MEP of at least `criterion_uv`, by integration over all three sources.
double responseProbability(const VirtualSubject& subject, double intensity_pct, double criterion_uv = 50);
/// The intensity at which it is one half, %.
double trueThreshold_pct(const VirtualSubject& subject, double criterion_uv = 50);

}  // namespace facenav::testing
