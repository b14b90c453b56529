#pragma once
// The sheet of face measures to hold against the person in the chair: is this scan of this patient, and is
// its scale right? Each with its uncertainty and the adult range: means of both sexes with two standard
// deviations over the widest populations found, rounded outwards; children differ. Sources, mean (sd) in mm:
//   head: ANSUR II 2012, men / women: circumference 574 (16) / 561 (19), length 200 (7) / 190 (7), breadth
//   154 (6) /
//     148 (5), pupils 51-77 apart; NIOSH 2003: circumference 576 (18) / 559 (21); length of British women 180
//     (7) (anthropometry tables of the City University of Hong Kong);
//   inner corners of the eyes: 67 studies pooled, 31.2 (1.5) Middle Eastern, 31.4 (2.5) White, 36.4 (1.6)
//   Asian,
//     38.5 (3.2) African (PMC9029890, 22 638 people);
//   nose: Kenyan men / women, height 51.0 (1.9) / 47.6 (3.1), width 43.2 (3.8) / 40.7 (3.7), face 134 (5) /
//   130 (4)
//     (Virdi 2019, doi 10.1186/s40902-019-0191-7);
//   all others: Farkas 1994, North American whites, without a second population.

#include <string>
#include <vector>

#include "facenav/surface/face_landmarks.h"

namespace facenav::surface {

struct FaceMeasure {
  std::string name, from, to;  // plain words, then the two landmarks
  double value_mm = 0;
  double uncertainty_mm = 0;                   // 95 of 100 repetitions stay within
  double usual_low_mm = 0, usual_high_mm = 0;  // adults; both 0 where no range is known
  bool is_lower_bound = false;                 // an end lies on the scan's edge: the true value may be larger

  /// Within the adult range, the uncertainty allowed for; a lower bound is only ever too large.
  bool isUsual() const;
};

/// Those measures whose landmarks were found. `voxel_mm`: the scan's largest voxel edge.
std::vector<FaceMeasure> measureFace(const FaceLandmarks& landmarks, double voxel_mm);

}  // namespace facenav::surface
