#pragma once
// VirtualSubject: a person whose MEPs are drawn from a published statistical model, to test threshold
// searches. Written from the equations and population parameters of Goetz, Alavi, Deng, Peterchev 2019,
// Statistical Model of Motor-Evoked Potentials, IEEE Trans Neural Syst Rehabil Eng 27(8): 1539-1545 (preprint
// doi 10.1101/406777):
// V = n + 10^(-7 + y + plateau / (1 + half / (x - onset + e)^steepness)) volt, x: intensity in % of output
// with e normal (the excitability varies), y normal (the pathway varies) and n of a generalised extreme value
// distribution (noise of the recording). Below onset there is no evoked part.

#include <random>

namespace facenav::testing {

struct VirtualSubject {
  double plateau = 0, half = 0, steepness = 0, onset_pct = 0;  // recruitment curve; plateau in decades
  double excitability_spread_pct = 0;                          // standard deviation of e
  double pathway_spread = 0;                                   // standard deviation of y, decades
  double noise_v = 0, noise_scale_v = 0, noise_shape = 0;      // location, scale and shape of n
};

/// Draws a subject from the population's distributions. Draws again if the curve does not rise from noise to
/// a large MEP between 20 and 120 % (as in the article), or if the threshold lies outside 30 to 100 %, which
/// a stimulator cannot measure (as in Wang, Peterchev, Goetz 2023).
VirtualSubject drawSubject(std::mt19937_64& random);

/// Draws the peak-to-peak amplitude of one MEP, uV.
double drawMep_uv(const VirtualSubject& subject, double intensity_pct, std::mt19937_64& random);

/// Probability of an MEP of at least `criterion_uv`, integrated over all three sources of variation.
double responseProbability(const VirtualSubject& subject, double intensity_pct, double criterion_uv = 50);
/// Intensity at which the response probability is one half, %.
double trueThreshold_pct(const VirtualSubject& subject, double criterion_uv = 50);

}  // namespace facenav::testing
