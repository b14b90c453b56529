#pragma once
// ThresholdRules: parameters of both methods to find a motor threshold (threshold.h). % of the maximal
// stimulator output (MSO).

#include "facenav/core/setting.h"

namespace facenav::stimulation {

struct ThresholdRules {
  static constexpr const char* kModule = "stimulation";
  static constexpr const char* kSubject = "motor threshold";

  double spread_share = 0.07, prior_mean_pct = 52, prior_spread_pct = 14, stop_width_pct = 4,
         interval_widening = 1.3;
  int most_pulses = 20;
  double response_uv = 50;
  double first_pct = 35, rise_pct = 5, descent_pct = 1;
  int sure_responses = 3;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(kModel("spread_share", 0.01, 0.5, "1", "bayes: spread of the response curve, of the threshold"),
            self.spread_share);
    visitor(kPrior("prior_mean_pct", 20, 90, "%", "bayes: threshold expected before the first pulse"),
            self.prior_mean_pct);
    visitor(kPrior("prior_spread_pct", 2, 50, "%", "bayes: standard deviation of that expectation"),
            self.prior_spread_pct);
    visitor(
        kStop("stop_width_pct", 0.5, 20, "%", "bayes: the search ends at this width of the 95 % interval"),
        self.stop_width_pct);
    visitor(kWide("interval_widening", 1, 3, "1", "bayes: the 95 % interval is widened by this factor"),
            self.interval_widening);
    visitor(kStop("most_pulses", 5, 100, "1", "bayes: the search ends after so many pulses"),
            self.most_pulses);
    visitor(kRule("response_uv", 10, 1000, "uV", "an MEP from here on counts as a response"),
            self.response_uv);
    visitor(kRule("first_pct", 5, 80, "%", "5of10: intensity of the first pulse"), self.first_pct);
    visitor(kRule("rise_pct", 1, 20, "%", "5of10: step upwards, until responses are sure"), self.rise_pct);
    visitor(kRule("descent_pct", 1, 5, "%", "5of10: step downwards"), self.descent_pct);
    visitor(kSure("sure_responses", 1, 10, "1", "5of10: responses in a row that end the way upwards"),
            self.sure_responses);
  }

  static constexpr Evidence kModel{
      Origin::article,
      "relative spread of the response curve in adaptive threshold hunting (Awiszus "
      "2003, Suppl Clin Neurophysiol 56: 13-23)"};
  static constexpr Evidence kPrior{
      Origin::fitted,
      "published table of 350 hotspots of the left first dorsal interosseous muscle "
      "(TMSMultiLab): median 52 %, standard deviation 13.7 %; none held out"};
  static constexpr Evidence kStop{
      Origin::chosen,
      "a stimulator is set in whole %, so +-2 % is what a treatment at 80 to 120 % of "
      "the threshold needs; checked on 200 virtual subjects, not chosen on them"};
  static constexpr Evidence kWide{Origin::fitted,
                                  "2000 virtual subjects (Goetz 2019), of 1.0, 1.1, 1.2, 1.3 and 1.4: there "
                                  "the interval held the truth in "
                                  "94.9 %; on 2000 others that were held out in 95.0 %. Without it: 88.7 %"};
  static constexpr Evidence kRule{
      Origin::article, "Groppa et al. 2012, Clin Neurophysiol 123: 858-882 (resting motor threshold)"};
  static constexpr Evidence kSure{Origin::chosen, "the article says 'consistently', without a number"};
};

}  // namespace facenav::stimulation
