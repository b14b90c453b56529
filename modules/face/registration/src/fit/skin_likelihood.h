#pragma once
// Likelihood of the cloud at a pose. Every patch of the cloud is either the patient's bare skin or covered:
// by hair, which is common above the hairline, by a hand, a coil or a face mask. Bare skin has one size of
// misfit and one size of detail over the whole face. A cover lies in front of the skin, hardly ever behind
// it, and has its own size of detail. Covers extend over several patches: the labels form a Potts field,
// whose cost grows with the border of the covered region and not with its area (Geman and Geman 1984). Labels
// and sizes are summed out by mean field. A sum of residuals is not enough: a pose midway between mask and
// brow fits all points loosely, while the right pose fits the bare skin closely and lies behind all of the
// mask.

#include <array>

#include "facenav/anatomy/face_regions.h"
#include "field_fit.h"

namespace facenav::registration {

class SkinLikelihood {
 public:
  /// `points`: indices in the cloud, in the order of the matches. The mean offsets of patches of `patch_mm`
  /// are treated as independent, since misfit is correlated over that distance. `noise_mm`: standard
  /// deviation of single points by the measurement.
  SkinLikelihood(const ScalpField& scalp, const PointCloud<Camera>& face, const std::vector<int>& points,
                 double noise_mm, double patch_mm = 25.0);

  /// Log likelihood of the matches of all points at a pose. Only differences between poses have a meaning.
  double operator()(const std::vector<PointMatch>& matches) const;

  /// Log likelihoods at a pose if the scan is this person's, and if it is another person's: then the skin
  /// lies millimetres off, on either side, and its detail differs.
  struct ByPerson {
    double own = 0.0, other = 0.0;
  };
  ByPerson byPerson(const std::vector<PointMatch>& matches) const;

  /// Probability at a pose that each point's patch is covered.
  std::vector<float> covered(const std::vector<PointMatch>& matches) const;

 private:
  static constexpr std::size_t kSizes = 6, kDetails = 4;
  struct Prior;
  struct Patch;
  struct Labels;
  static const Prior kOwn, kOther;
  std::vector<Patch> gather(const std::vector<PointMatch>& matches) const;
  static std::vector<double> coveredAlone(const std::vector<Patch>& patches, std::size_t detail);
  Labels label(const std::vector<Patch>& patches, std::size_t detail, const Prior& prior,
               std::vector<double> covered_at_first) const;
  Labels unlabelled(const std::vector<Patch>& patches) const;
  static double mostEvidence(const std::vector<Patch>& patches, std::size_t detail, const Prior& prior,
                             double agreement);
  template <class Visitor>
  double sumOut(const std::vector<Patch>& patches, const Prior& prior, Visitor&& visit) const;
  double energy(const std::vector<double>& covered, const std::vector<Patch>& patches) const;
  double pull(const std::vector<double>& covered, std::size_t patch) const;

  anatomy::FaceRegions regions_;
  double noise_mm_ = 0.0;
  double full_ = 0.0;                         // number of points in a fully visible patch
  std::vector<int> patch_of_;                 // patch of each point
  std::vector<std::vector<int>> neighbours_;  // neighbours of each patch
};

}  // namespace facenav::registration
