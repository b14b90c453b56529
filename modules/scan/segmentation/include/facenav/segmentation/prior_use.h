#pragma once
// PriorUse: settings for refining the learned brain prior (Data/brain_prior) by the scan's own intensities,
// and for bounding the growth of brain_growth.h by it.

#include "facenav/core/setting.h"

namespace facenav::segmentation {

struct PriorUse {
  static constexpr const char* kModule = "segmentation";
  static constexpr const char* kSubject = "brain prior";

  double search_mm = 2;
  double core_mm = 6;
  double least_agreement = 0.955;
  double far_mm = 4;
  double most_far = 0.002;
  double band_mm = 5;
  double sample_mm = 8;
  double lattice_mm = 10;
  int lattice_smoothings = 2;
  double evidence = 3;
  int evidence_smoothings = 2;
  int rounds = 2;
  double other_reach_mm = 10;
  double other_lattice_mm = 15;
  int other_rounds = 3;
  double other_prior = 0.7;
  double other_most_prior = 1.5;
  double other_evidence = 1.5;
  double other_inwards = 0.3;
  double sulcus_mm = 2;
  double smooth_mm = 1.5;
  double doubt_base_mm = 0.2;
  double doubt_width = 0.15;
  double doubt_moved = 0.3;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(kHeads("prior_search_mm", 0, 30, "mm",
                   "tissue is grown at most this far outside the prior's outline"),
            self.search_mm);
    visitor(kHeads("prior_core_mm", 0, 30, "mm", "what lies this deep within the prior's outline is brain"),
            self.core_mm);
    visitor(kHeads("prior_least_agreement", 0, 1, "1",
                   "Dice of growth and refined prior that is taken for agreement"),
            self.least_agreement);
    visitor(kFar("prior_far_mm", 0, 30, "mm",
                 "what growth or refined prior has this far from the other is a leak or a gap"),
            self.far_mm);
    visitor(kFar("prior_most_far", 0, 1, "1",
                 "share of the prior's volume in leaks and gaps that is taken for agreement"),
            self.most_far);
    visitor(kHeads("prior_band_mm", 0, 20, "mm",
                   "the scan's intensities move the prior's outline at most this far"),
            self.band_mm);
    visitor(kHeads("prior_sample_mm", 1, 30, "mm",
                   "this far on either side of the outline intensities are compared"),
            self.sample_mm);
    visitor(kHeads("prior_lattice_mm", 4, 40, "mm", "distance of the places where they are compared"),
            self.lattice_mm);
    visitor(kHeads("prior_lattice_smoothings", 0, 10, "1", "how often neighbouring places are averaged"),
            self.lattice_smoothings);
    visitor(kHeads("prior_evidence", 0, 5, "1", "weight of the intensities against the prior"),
            self.evidence);
    visitor(
        kHeads("prior_evidence_smoothings", 0, 20, "1", "how often the evidence of neighbours is averaged"),
        self.evidence_smoothings);
    visitor(kHeads("prior_rounds", 0, 5, "1", "how often intensities are compared anew"), self.rounds);
    visitOthers(self, visitor);
    visitor(kHeads("prior_sulcus_mm", 0, 10, "mm", "sulci up to twice this wide are closed"), self.sulcus_mm);
    visitor(kHeads("prior_smooth_mm", 0, 5, "mm", "spikes thinner than twice this are cut"), self.smooth_mm);
    visitDoubt(self, visitor);
  }

 private:
  template <class Self, class Visitor>
  static void visitOthers(Self& self, Visitor&& visitor) {
    visitor(kOthers("prior_other_reach_mm", 1, 30, "mm",
                    "no clear T1: tissue and fluid are told apart this far on either side of the outline"),
            self.other_reach_mm);
    visitor(kOthers("prior_other_lattice_mm", 4, 40, "mm", "distance of the places of their histograms"),
            self.other_lattice_mm);
    visitor(kOthers("prior_other_rounds", 1, 10, "1", "how often histograms and classes are estimated"),
            self.other_rounds);
    visitor(kOthers("prior_other_prior", 0, 5, "1", "weight of the prior's log odds"), self.other_prior);
    visitor(kOthers("prior_other_most_prior", 0, 6, "1",
                    "most log odds of the prior that a place is brain: open sulci lie deep within it"),
            self.other_most_prior);
    visitor(kOthers("prior_other_evidence", 0, 5, "1", "weight of the intensities' log ratio"),
            self.other_evidence);
    visitor(kOthers("prior_other_inwards", -5, 5, "1", "log odds that a place needs to be brain"),
            self.other_inwards);
  }

  template <class Self, class Visitor>
  static void visitDoubt(Self& self, Visitor&& visitor) {
    visitor(kDoubts("doubt_base_mm", 0, 5, "mm", "stated doubt of the refined outline, least"),
            self.doubt_base_mm);
    visitor(
        kDoubts("doubt_width", 0, 5, "1", "stated doubt per distance of the prior's levels 0.25 and 0.75"),
        self.doubt_width);
    visitor(kDoubts("doubt_moved", 0, 5, "1", "stated doubt per distance that the scan moved the outline"),
            self.doubt_moved);
  }

  static constexpr Evidence kHeads{
      Origin::fitted,
      "on nine synthetic heads of the anatomy that the network learned from (T1: 03 04 09 14 20, any "
      "contrast: 06 11 15 "
      "18), Colin27 and one whole head, a few values tried of each; heads 02 07 12 17 held out"};
  static constexpr Evidence kFar{
      Origin::fitted,
      "on twelve synthetic T1s of the anatomy that the network learned from (03 04 06 08 09 11 13 14 15 18 "
      "19 "
      "20, seeds 101 to 112): at shares up to 0.0019 growth and prior have the same Dice within 0.015 either "
      "way, from 0.0044 on growth is the worse one, by up to 0.1; three real scans were seen in the same "
      "table "
      "(0.0002 to 0.0012); heads 02 07 12 17 held out"};
  static constexpr Evidence kOthers{
      Origin::fitted,
      "on 40 heads of any contrast painted from heads 02 07 12 17, which the network never saw, seeds 5001 "
      "to "
      "5040 (some twenty sets of values tried on 8 or 12 of them, nine on all): Dice median 0.954, least "
      "0.918. Each of the four anatomies held out in turn, the nine sets chosen on the other three: median "
      "0.952, least 0.920"};
  static constexpr Evidence kDoubts{Origin::chosen,
                                    "so that about as many places are stated within 2 mm as are, on the same "
                                    "heads; heads 02 07 12 17 held out"};
};

}  // namespace facenav::segmentation
