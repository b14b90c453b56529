#pragma once
// What a person needs to judge an alignment before guiding: the MRI's skin over both pictures, and where the
// coil's tip, held to nose and ear, or a spot that is picked in a picture is on the MRI's skin. Window and
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

/// Named places that a tip is held to: nose tip, nasion, both tragi; those that are known. The landmarks are
/// the case's own; at the first call they are found, which takes a second or two.
std::vector<surface::NamedPlace> placesToTouch(const casefile::CaseStore& store,
                                               const surface::ScalpSurface& scalp,
                                               const registration::ScalpField* field);
/// For a worker thread.
AlignmentSeen seeAlignment(const casefile::CaseStore& store, const AlignmentOutcome& alignment);
/// The skin over the pictures that the alignment was made from.
pictures::CameraOverlay drawAlignment(const cameras::StereoRig& rig, const AlignmentOutcome& alignment,
                                      const AlignmentSeen& seen);
/// Where the coil's tip is; nothing while head or coil is lost.
std::optional<guidance::TipReading> readTip(const session::NavigationState& state, const Point<Coil>& tip,
                                            const guidance::TipCheck& check);
/// Where a spot is that a person picks in one of the state's pictures (a finger's tip held to the nose, a
/// mole); px. Nothing while the head is lost, after a camera moved, or where the spot is not found in the
/// other picture near the MRI's skin.
std::optional<guidance::TipReading> readPickedSpot(const session::NavigationState& state,
                                                   const cameras::StereoRig& rig, stereo::PictureSide side,
                                                   const Eigen::Vector2d& px,
                                                   const guidance::TipCheck& check);

/// What a person says of a tip reading.
enum class TipVerdict { right, wrong };
/// As the session's event keeps it: "judged right: 0.8 mm outside the skin, 3.2 mm from nose tip; tip at
/// (1.2, 98.4, -20.1) mm in the MRI"; of a spot: "picked spot at".
std::string inWords(TipVerdict verdict, const guidance::TipReading& reading);

}  // namespace facenav::steps
