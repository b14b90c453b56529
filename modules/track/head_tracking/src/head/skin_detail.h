#pragma once
// Identity check: is the skin at a fitted pose the patient's? Faces resemble each other in everything coarse:
// eyes, brows and mouth of another person, aligned with the patient's, match patch by patch. The fine detail
// (pores, freckles, single hairs: some 2 to 5 pixels) is individual. So the patches are compared in that band
// only, and all that do not clearly show something else are pooled. The agreement is 1 when all detail above
// the noise is the patient's (noise lowers the expected correlation, not the agreement), and near 0
// otherwise. Only edges that all faces share, and that the fit has aligned, keep it above 0. Measured in the
// virtual room, heads turned by up to 30 deg, at every fitted pose, relative to the agreement of both cameras
// in the reference (least, median, most):
//
// | heads                                           | the patient        | others               |
// |-------------------------------------------------|--------------------|----------------------|
// | three, one dark, 3 rigs: 24 poses, 24 others    | 0.80 / 0.91 / 0.99 | -0.06 / 0.14 / 0.34  |
// | one, recorded as JPEG of quality 75: 5 poses, 5 | 0.86 / 0.92 / 0.96 |  0.00 / 0.11 / 0.24  |

#include <array>

#include "patch_model.h"
#include "patch_placement.h"
#include "pose_fit.h"

namespace facenav::head_tracking {

/// Sums over patches and cameras.
struct DetailAgreement {
  double product = 0.0;   // of the measured times the expected correlations
  double expected = 0.0;  // of the squared expected correlations, by noise alone

  double value() const;
  double sigma() const;  // from noise and chance
};

/// Agreement of the face at `fit` with the key frame of that fit. `now`: with level 0 at least; `share`:
/// subset of the patches (a part is enough while tracking).
DetailAgreement detailAgreement(const cameras::StereoRig& rig, const PatchModel& model,
                                const PatchLevel& finest, const std::array<ImagePyramid, 2>& now,
                                const PoseFit& fit, const PatchShare& share = {});

/// Agreement of the left and the right reference image, which show the same skin: the best that these cameras
/// and this skin allow.
DetailAgreement detailOfBothCameras(const PatchModel& model);

/// The verdict, with three standard errors on either side; undecided in between (dark, blurred, far).
enum class SkinIdentity { patient, undecided, other_person };
SkinIdentity identityOfSkin(const DetailAgreement& seen, const DetailAgreement& of_both_cameras);

}  // namespace facenav::head_tracking
