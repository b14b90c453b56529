#pragma once
// The sites of the international 10-20 system on a scalp (Jasper 1958; with the planes of Jurcak, Tsuzuki and
// Dan 2007): tapes over the head, each held in a plane and spanning hollows (surface/scalp_path.h), divided
// in steps of 10 and 20 %.
// - nasion - Cz - inion: Fpz 10 %, Fz 30, Cz 50, Pz 70, Oz 90;
// - left tragus - Cz - right tragus: T7 10 %, C3 30, Cz 50, C4 70, T8 90. Cz is the middle of both;
// - Fpz - T7 - Oz and Fpz - T8 - Oz: Fp1 10 %, F7 30, P7 70, O1 90, and on the right alike;
// - F7 - Fz - F8 and P7 - Pz - P8: F3 and F4, P3 and P4, in the middle between neighbours.
// T3, T4, T5, T6 are other names of T7, T8, P7, P8.

#include <string>
#include <vector>

#include "facenav/surface/scalp_landmarks.h"
#include "facenav/surface/scalp_path.h"

namespace facenav::guidance {

struct EegSite {
  std::string name;
  Point<Mri> point;    // on the skin
  double span_mm = 0;  // height of the tape above the skin there (it spans hollows)
  double sd_mm = 0;    // standard error caused by the landmarks' errors
};

struct EegSites {
  std::vector<EegSite> sites;  // the 19 of the 10-20 system, Fpz and Oz, from front to back
  double nasion_inion_mm = 0, tragus_tragus_mm = 0;
  double circumference_mm = 0;  // over Fpz, T7, Oz, T8

  /// Finds a site by name: current or old name, in any case. Throws Error that lists the names.
  const EegSite& find(const std::string& name) const;
};

/// Places all sites. Throws Error if a landmark is unknown, or if the scalp has no skin where a tape should
/// lie.
EegSites placeEegSites(const surface::ScalpPaths& scalp, const surface::ScalpLandmarks& landmarks);
/// Places all sites and computes sd_mm by moving each landmark by its standard error along the skin, in two
/// directions. Takes about nine times as long as placeEegSites.
EegSites placeEegSitesWithErrors(const surface::ScalpPaths& scalp, const surface::ScalpLandmarks& landmarks);

/// Names that find() accepts, in the order of EegSites::sites.
const std::vector<std::string>& eegSiteNames();

}  // namespace facenav::guidance
