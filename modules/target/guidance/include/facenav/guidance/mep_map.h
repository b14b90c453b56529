#pragma once
// MepMap: motor evoked potentials by where the coil pointed, smoothed over a surface: heat map, area, centre
// of gravity and peak. The map at a vertex is the mean of the MEPs, each weighted by exp(-d^2 / 2 sigma^2) of
// the straight distance d from its site (kernel regression of Nadaraya and Watson, 1964). Vertices without a
// site nearby have no value. All in Mri mm; MEPs in uV, peak to peak.

#include <optional>
#include <vector>

#include "facenav/core/setting.h"
#include "facenav/guidance/target.h"
#include "facenav/surface/triangle_mesh.h"

namespace facenav::guidance {

struct MepSite {
  Point<Mri> point;   // where the coil's axis meets the surface
  double mep_uv = 0;  // 0: no response
};

struct MepMapOptions {
  static constexpr const char* kModule = "guidance";
  static constexpr const char* kSubject = "MEP map";
  double mep_sigma_mm = 5.0, mep_reach_mm = 10.0, mep_threshold_uv = 50.0;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(kWidth("mep_sigma_mm", 0.5, 30, "mm", "width (sigma) of the Gaussian that smooths the MEP map"),
            self.mep_sigma_mm);
    visitor(kWidth("mep_reach_mm", 1, 60, "mm", "the map ends this far from the nearest site"),
            self.mep_reach_mm);
    visitor(kThreshold("mep_threshold_uv", 1, 5000, "uV", "from here on a place counts to the area"),
            self.mep_threshold_uv);
  }
  static constexpr Evidence kWidth{Origin::chosen,
                                   "about the spacing of the usual 7 x 7 grid; not fitted, nothing compared"};
  static constexpr Evidence kThreshold{
      Origin::article, "a response is 50 uV or more (Rossini et al. 1994, 2015, clinical guidelines)"};
};

struct MepMap {
  std::vector<float> mep_uv;           // one per vertex; NaN: no site near
  double area_mm2 = 0;                 // area of the surface where the map reaches the threshold
  Point<Mri> centre_of_gravity;        // mean of the sites, weighted by MEP (Wassermann et al. 1992)
  Point<Mri> peak;                     // vertex with the map's largest value, within sigma of a site
  double peak_uv = 0, largest_uv = 0;  // largest value of the map; largest single MEP
  int sites = 0, responses = 0;        // responses: sites at or above the threshold
};

/// Computes the map. Returns nothing if no site gave a response (all MEPs 0) or no vertex lies near one.
/// Takes milliseconds for a brain model and some hundred sites.
std::optional<MepMap> mepMap(const surface::TriangleMesh& surface, const std::vector<MepSite>& sites,
                             const MepMapOptions& options);

/// Returns where the coil's axis, from its contact face into the head, first meets the surface; nothing if it
/// misses.
std::optional<Point<Mri>> axisOnSurface(const surface::TriangleMesh& surface,
                                        const RigidTransform<Mri, Coil>& mri_T_coil);

}  // namespace facenav::guidance
