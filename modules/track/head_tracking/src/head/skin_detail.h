#pragma once
// Identity check by fine detail: is the skin at a fitted pose the patient's? Faces resemble each other in
// everything coarse: eyes, brows and mouth of another person, aligned with the patient's, match patch by
// patch.
// The fine detail (pores, freckles, single hairs: some 2 to 5 pixels) is individual. So the patches are
// compared in that band only, and all that do not clearly show something else are pooled.
//
// The agreement is 1 if all detail above the noise is the patient's (noise lowers the expected correlation,
// not the agreement), and near 0 otherwise. Edges that all faces share, and that the fit has aligned, keep it
// slightly above 0. Relative to the agreement of both cameras in the reference it is 0.8 or more for the
// patient, and below 0.35 for others. Evidence: resources/doc/evidence.md.

#include <array>

#include "patch_model.h"
#include "patch_placement.h"
#include "pose_fit.h"

namespace facenav::head_tracking {

/// Sums over patches and cameras.
struct DetailAgreement {
  double product = 0.0;   // sum of measured times expected correlations
  double expected = 0.0;  // sum of squared expected correlations, with noise alone

  double value() const;
  double sigma() const;  // from noise and chance
};

/// Agreement of the face at `fit` with the key frame of that fit. `now`: with level 0 at least; `share`:
/// subset of the patches (a part is enough while tracking).
DetailAgreement detailAgreement(const cameras::StereoRig& rig, const PatchModel& model,
                                const PatchLevel& finest, const std::array<ImagePyramid, 2>& now,
                                const PoseFit& fit, const PatchShare& share = {});

/// Agreement of the left and the right reference image, which show the same skin: an upper bound for these
/// cameras and this skin.
DetailAgreement detailOfBothCameras(const PatchModel& model);

/// The verdict, with three standard errors on either side; undecided in between (dark, blurred, far).
enum class SkinIdentity { patient, undecided, other_person };
SkinIdentity identityOfSkin(const DetailAgreement& seen, const DetailAgreement& of_both_cameras);

}  // namespace facenav::head_tracking
