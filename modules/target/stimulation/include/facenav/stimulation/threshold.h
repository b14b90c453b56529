#pragma once
// Motor threshold: the intensity at which half of the pulses give a response (MEP of 50 uV or more at rest,
// or a visible twitch). Pure functions of the answers so far return the estimate and the next intensity.
// Intensities in % of the maximal stimulator output (MSO), in whole % as stimulators are set.
//
// bayes: posterior over the threshold, with a cumulative normal response curve of known relative spread and a
// normal prior; each pulse at the posterior mean. Wang, Peterchev, Goetz 2023, J Neural Eng 20: 056002,
// compare such methods. The spread differs between people, so the posterior is too narrow; its 95 % interval
// is widened by a fitted factor (threshold_rules.h). Evidence: resources/doc/evidence.md.
// 5of10: the relative-frequency rule (Rossini et al. 1994; steps of Groppa et al. 2012, Clin Neurophysiol
// 123: 858): upwards until responses are sure, then downwards to the first level with fewer than 5 of 10; the
// threshold is one step above it. It gives no interval, and takes about four times as many pulses.

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace facenav::stimulation {

enum class ThresholdMethod { bayes, five_of_ten };
/// Returns "bayes" or "5of10".
std::string toString(ThresholdMethod method);
/// Parses the method's name. Throws Error that names both for another word.
ThresholdMethod thresholdMethodFrom(const std::string& word);

struct ThresholdAnswer {
  double intensity_pct = 0;
  bool has_response = false;
};

struct ThresholdState {
  int pulses = 0, responses = 0;                      // of these
  std::optional<double> estimate_pct;                 // 5of10: the lowest level passed so far
  std::optional<std::array<double, 2>> interval_pct;  // 95 %; nothing: the method gives none
  std::optional<double> next_pct;                     // nothing: done
  bool is_above_output = false;                       // the search ended without a threshold up to 100 %
  std::string level;                                  // 5of10: "at 52 %: 3 responses, 2 without"; else empty

  bool isDone() const { return !next_pct; }
};

/// Evaluates the answers by the rules in force (threshold_rules.h). Answers may lie at other intensities than
/// those asked for; 5of10 ignores them. Throws Error for an intensity outside 0..100.
ThresholdState thresholdAfter(ThresholdMethod method, const std::vector<ThresholdAnswer>& answers);

/// Returns "52.3 % (95 % interval 50.4 to 54.1), bayes, 9 responses of 18 pulses" or "not found up to 100 %,
/// ..".
std::string inWords(const ThresholdState& state, ThresholdMethod method);

}  // namespace facenav::stimulation
