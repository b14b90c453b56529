#pragma once
// Upper bound of a rate that was measured by counting.
// Source: Clopper, Pearson 1934, Biometrika 26: 404-413; without an event it is the "rule of three" (3 / n).

namespace facenav::evaluation {

/// Returns the rate (0..1) that is exceeded with 95 % confidence by no process that gave `events` in
/// `trials`, one-sided; 1 without a trial.
double rateBound95(int events, int trials);

}  // namespace facenav::evaluation
