#pragma once
// FitLimits: when an alignment is refused, or accepted with a caution. A wider limit may let another person's
// scan pass. Judge a change by `facenav evaluate` on heads and faces that the evidence does not name.

#include "facenav/core/setting.h"

namespace facenav::registration {

struct FitLimits {
  static constexpr const char* kModule = "registration";
  static constexpr const char* kSubject = "right and wrong heads";

  double least_own = 6.0;
  double mostly_bare = 0.7;
  double mirrored = -5.0;
  double least_unmirrored = 20.0;
  double chosen_parts = 120.0;
  double rival = 3.0;
  double scanner_scale = 0.01;
  double caution_scale_z = 3.0;
  double refused_scale_z = 3.0;
  double refused_turn_z = 3.0;
  double loose_mm = 0.6;
  double hairy = 0.35;
  double least_extent_mm = 45.0;
  double large_error_mm = 2.0;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(kHeads("least_own", 0, 50, "1",
                   "least log odds of this person's scan against another person's (the skin's misfit, by its "
                   "size and detail)"),
            self.least_own);
    visitor(kMasks("mostly_bare", 0, 1, "1", "share of bare skin below which the face counts as covered"),
            self.mostly_bare);
    visitor(kMirror("mirrored", -50, 0, "1",
                    "log odds against the mirror image below which the scan is mirrored"),
            self.mirrored);
    visitor(kStrangers("least_unmirrored", 0, 100, "1",
                       "least log odds of a face that nothing covers against its mirror image"),
            self.least_unmirrored);
    visitor(kStrangers("chosen_parts", 0, 500, "1",
                       "what these odds must be more, by the share of the face that counts as covered"),
            self.chosen_parts);
    visitor(kOdds("rival", 0, 20, "1", "least log odds against the best pose elsewhere"), self.rival);
    visitor(kExtent("least_extent_mm", 10, 200, "mm",
                    "least extent of the measured face, four sigma, across or up"),
            self.least_extent_mm);
    visitSize(self, visitor);
  }

 private:
  template <class Self, class Visitor>
  static void visitSize(Self& self, Visitor&& visitor) {
    visitor(
        kScanner("scanner_scale", 0, 0.05, "1", "standard error of size that scanners and calibrations have"),
        self.scanner_scale);
    visitor(
        kChance(
            "caution_scale_z", 1, 10, "1",
            "size error above which a caution is given, in standard errors of the fit and of usual scans"),
        self.caution_scale_z);
    visitor(kChance("refused_scale_z", 2, 20, "1",
                    "size error that is refused, in standard errors of the fit and of scanner_scale"),
            self.refused_scale_z);
    visitor(
        kChance("refused_turn_z", 2, 20, "1",
                "turn of a camera sideways since the calibration that is refused, in standard errors of the "
                "fit and of scanner_scale"),
        self.refused_turn_z);
    visitor(
        kNotRecorded("loose_mm", 0.1, 3, "mm",
                     "distance of the bare skin, or size of the misfit, above which a loose fit is reported"),
        self.loose_mm);
    visitor(kNotRecorded("hairy", 0.05, 1, "1", "places with hair more often than this are not compared"),
            self.hairy);
    visitor(
        kGoal("large_error_mm", 0.5, 5, "mm", "predicted error in the brain from which on it is reported"),
        self.large_error_mm);
  }

  static constexpr Evidence kHeads{
      Origin::fitted,
      "on surfaces of painted heads 02 04 06 08 12 14: own faces, children and rescans with 1 to 2 % scale "
      "error "
      "6.7 and more, 30 pairs of strangers 3.9 at most; held out: heads 03 07 09 13 15 17-20, the virtual "
      "patient, Colin27: own whole faces 60 of 60 above, strangers 0 of 110"};
  static constexpr Evidence kMasks{Origin::fitted,
                                   "on masked faces of the virtual room (5 heads, 3 rigs, 3 seeds): bare "
                                   "0.3-1 of the face; it only decides about a caution and about points on "
                                   "covers; no other heads held out"};
  static constexpr Evidence kMirror{
      Origin::fitted,
      "on captures of the virtual room, the number not recorded: right heads +5 to +29 (+6.5 and more with "
      "the later fit), mirrored -5 to -55 (-9.7 and less); no other heads held out"};
  static constexpr Evidence kStrangers{
      Origin::fitted,
      "on drawn worlds 12000-12014 and 13000-13026 (even seeds, faces of 90 to 480 px): 15 other heads under "
      "their pictures, of which 4 pass the gate 'this person', have 7 to 39 at 0.46 to 0.86 bare, their own "
      "heads 33 and more but for 3 of 112 to 198 px; held out: odd worlds 14001-14027, 0 of 26 other heads "
      "accepted, 4 of 14 own ones refused by this alone"};
  static constexpr Evidence kOdds{Origin::chosen, "odds of 20 to 1"};
  static constexpr Evidence kScanner{
      Origin::chosen,
      "scanners without correction of their gradients are off by 1 to 2 % (two standard errors)"};
  static constexpr Evidence kChance{Origin::physics, "tails of the normal distribution"};
  static constexpr Evidence kNotRecorded{Origin::chosen,
                                         "origin not recorded; in development on heads of the virtual room"};
  static constexpr Evidence kExtent{
      Origin::fitted,
      "strips of 25 to 40 mm of a face, painted heads 02 06 08 12 14 15 18: the pose holds (50 of 60 "
      "aligned, all inside the bound), but 5 of 168 strips of strangers fit a forehead as closely as this "
      "person's; no other heads held out"};
  static constexpr Evidence kGoal{
      Origin::chosen,
      "2 mm: the largest error that navigation should have; painted heads 02 04 06 08 12 14 at 2 to 3 mm "
      "predicted were 1.8 mm off at most"};
};

}  // namespace facenav::registration
