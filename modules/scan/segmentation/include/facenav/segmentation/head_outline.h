#pragma once
// HeadOutline: settings for the head's edge and for things that touch it (pads, earphones, haze).

#include "facenav/core/setting.h"

namespace facenav::segmentation {

struct HeadOutline {
  static constexpr const char* kModule = "segmentation";
  static constexpr const char* kSubject = "head's outline";

  double local_share = 0.35;
  double tissue_reach_mm = 16;
  double pad_away_mm = 5;
  double pad_least_ml = 3;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(kHeads("outline_local_share", 0.05, 0.6, "1",
                   "limit between air and tissue: 0 is the air around a place, 1 the tissue there"),
            self.local_share);
    visitor(
        kHeads("outline_tissue_reach_mm", 4, 40, "mm", "tissue this deep below a place is the tissue there"),
        self.tissue_reach_mm);
    visitor(kHeads("outline_pad_away_mm", 2, 20, "mm",
                   "what the brain prior sees as air is a pad if it reaches this far from the head"),
            self.pad_away_mm);
    visitor(kHeads("outline_pad_least_ml", 0.1, 50, "ml", "smaller things beside the head are left (ears)"),
            self.pad_least_ml);
  }

 private:
  static constexpr Evidence kHeads{
      Origin::fitted,
      "on the virtual patient, Colin27 and painted heads 03 06 09, with made halos, pads, earphones and "
      "shading; heads 02 07 12 17 held out"};
};

}  // namespace facenav::segmentation
