#pragma once
// How well a pose explains the cloud, as a likelihood. Every patch of the cloud is either the patient's bare
// skin or covered: by hair, which is common above the hairline, by a hand, a coil, a face mask. Bare skin is
// off by a misfit of a size, and shows detail of another, that are the same all over the face; what covers
// lies before the skin, hardly ever behind it, and has detail of its own. Covers reach over neighbours:
// labels of patches are a Potts field, whose cost goes with the rim of what is covered, not with its area
// (Geman and Geman 1984); labels and sizes are summed out by mean field. What a sum of residuals cannot tell:
// a pose midway between mask and brow fits all of it loosely, the right one fits the bare skin closely and
// lies behind all of the mask.

#include <array>

#include "facenav/anatomy/face_regions.h"
#include "field_fit.h"

namespace facenav::registration {

class SkinLikelihood {
 public:
  /// For the `points` of the cloud, in their order. Patches of `patch_mm` count as independent, as far as
  /// their mean offset goes, since misfit reaches that far.
  SkinLikelihood(const ScalpField& scalp, const PointCloud<Camera>& face, const std::vector<int>& points,
                 double patch_mm = 25.0);

  /// Logarithm of the likelihood of the matches of all points at a pose; differences tell poses apart.
  double operator()(const std::vector<PointMatch>& matches) const;

  /// How likely each point's patch is covered, at a pose.
  std::vector<float> covered(const std::vector<PointMatch>& matches) const;

 private:
  static constexpr std::size_t kSizes = 5, kDetails = 4;
  struct Patch;
  struct Labels;
  std::vector<Patch> gather(const std::vector<PointMatch>& matches) const;
  static std::vector<double> coveredAlone(const std::vector<Patch>& patches, std::size_t detail);
  Labels label(const std::vector<Patch>& patches, std::size_t detail,
               std::vector<double> covered_at_first) const;
  Labels unlabelled(const std::vector<Patch>& patches) const;
  double mostEvidence(const std::vector<Patch>& patches, std::size_t detail) const;
  template <class Visitor>
  double sumOut(const std::vector<Patch>& patches, Visitor&& visit) const;
  double energy(const std::vector<double>& covered, const std::vector<Patch>& patches) const;
  double pull(const std::vector<double>& covered, std::size_t patch) const;

  anatomy::FaceRegions regions_;
  double full_ = 0.0;                         // points of a patch that is seen in full
  std::vector<int> patch_of_;                 // each point's
  std::vector<std::vector<int>> neighbours_;  // of each patch
};

}  // namespace facenav::registration
