#pragma once
// IdentityModel: likelihoods of the identity check's observations for the patient and for another person
// (src/recovery/identity.h). The evidence is one real person. Judge a change on persons whom it does not name
// (`facenav evaluate pairs`).

#include "facenav/core/setting.h"

namespace facenav::head_tracking {

struct IdentityModel {
  static constexpr const char* kModule = "head_tracking";
  static constexpr const char* kSubject = "identity of a face found again";

  double identity_rigid_mm = 0.6;
  double identity_in_place = 0.15;
  double identity_least_in_place_px = 1.0;
  double identity_own_mean = 0.8;
  double identity_own_sigma = 0.75;
  double identity_other_mean = -2.7;
  double identity_other_sigma = 0.6;
  double identity_sure = 4.6;
  double identity_prior = 2.3;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(kNotRecorded("identity_rigid_mm", 0.1, 3, "mm", "mobility of the skin that is asked"),
            self.identity_rigid_mm);
    visitor(kNotRecorded("identity_in_place", 0.02, 1, "1",
                         "residual of a window in its place, of half a window"),
            self.identity_in_place);
    visitor(kNotRecorded("identity_least_in_place_px", 0.2, 5, "px", "least such residual"),
            self.identity_least_in_place_px);
    visitor(kOwn("identity_own_mean", -3, 5, "1", "logit of the patient's share of windows in place: mean"),
            self.identity_own_mean);
    visitor(kOwn("identity_own_sigma", 0.1, 3, "1",
                 "logit of the patient's share of windows in place: standard deviation"),
            self.identity_own_sigma);
    visitor(kOther("identity_other_mean", -6, 2, "1", "logit of another person's share: mean"),
            self.identity_other_mean);
    visitor(
        kOther("identity_other_sigma", 0.1, 3, "1", "logit of another person's share: standard deviation"),
        self.identity_other_sigma);
    visitor(kOdds("identity_sure", 1, 20, "1", "log likelihood ratio of a decision: 100 to 1"),
            self.identity_sure);
    visitor(
        kPrior(
            "identity_prior", 0, 10, "1",
            "log odds, before the skin is seen, that a face where the patient's was lost is the patient's"),
        self.identity_prior);
  }

 private:
  static constexpr Evidence kOwn{
      Origin::fitted,
      "on one real person, 60 attempts over five moments and three pairs of cameras (0.82, 0.65), widened "
      "for people and cameras that were not seen; nobody held out. At that time the residuals contained the "
      "skin's smooth motion; without it, the share is higher in grimaces"};
  static constexpr Evidence kOther{
      Origin::fitted,
      "on the same person mirrored, 25 attempts (-2.7, 0.33; the program is not kept), widened; nobody held "
      "out. Without the skin's smooth motion, others reach 0.15 (logit -1.7) in five drawn worlds of even "
      "seeds"};
  static constexpr Evidence kOdds{Origin::chosen, "odds of 100 to 1"};
  static constexpr Evidence kPrior{Origin::chosen,
                                   "10 to 1: the patient's head comes back to its chair far more often than "
                                   "another's takes its place"};
  static constexpr Evidence kNotRecorded{Origin::chosen,
                                         "origin not recorded; in development on one real person"};
};

}  // namespace facenav::head_tracking
