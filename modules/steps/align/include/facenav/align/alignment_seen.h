#pragma once
// What a person needs to judge an alignment before guiding: the MRI's skin over both pictures, and the
// position on that skin of the coil's tip (held to nose and ear) or of a spot picked in a picture. Window and
// command line use the same functions.

#include <memory>
#include <string>

#include "facenav/align/align_from_capture.h"
#include "facenav/casefile/case_store.h"
#include "facenav/guidance/tip_check.h"
#include "facenav/pictures/aligned_skin.h"
#include "facenav/session/navigation_state.h"
#include "facenav/stereo/picked_spot.h"

namespace facenav::steps {

struct AlignmentSeen {
  std::shared_ptr<const pictures::AlignedSkin> skin;
  std::shared_ptr<const guidance::TipCheck> check;
};

/// Returns the known ones of the places that a tip is held to: nose tip, nasion, both tragi. The landmarks
/// are the case's own; the first call finds them, which takes a second or two.
std::vector<surface::NamedPlace> placesToTouch(const casefile::CaseStore& store,
                                               const surface::ScalpSurface& scalp,
                                               const registration::ScalpField* field);
/// Prepares the check, on a worker thread.
AlignmentSeen seeAlignment(const casefile::CaseStore& store, const AlignmentOutcome& alignment);
/// Draws the skin over the pictures that the alignment was made from.
pictures::CameraOverlay drawAlignment(const cameras::StereoRig& rig, const AlignmentOutcome& alignment,
                                      const AlignmentSeen& seen);
/// Position of the coil's tip; nothing while head or coil is lost.
std::optional<guidance::TipReading> readTip(const session::NavigationState& state, const Point<Coil>& tip,
                                            const guidance::TipCheck& check);
/// Position of a spot that a person picks in one of the state's pictures (a fingertip held to the nose, a
/// mole); px. Nothing while the head is lost, after a camera moved, or if the spot is not found in the other
/// picture near the MRI's skin.
std::optional<guidance::TipReading> readPickedSpot(const session::NavigationState& state,
                                                   const cameras::StereoRig& rig, stereo::PictureSide side,
                                                   const Eigen::Vector2d& px,
                                                   const guidance::TipCheck& check);

/// A person's verdict on a tip reading.
enum class TipVerdict { right, wrong };
/// Detail of the session's event: "judged right: 0.8 mm outside the skin, 3.2 mm from nose tip; tip at (1.2,
/// 98.4, -20.1) mm in the MRI"; for a spot: "picked spot at".
std::string inWords(TipVerdict verdict, const guidance::TipReading& reading);

}  // namespace facenav::steps
