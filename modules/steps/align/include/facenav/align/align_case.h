#pragma once
// ALIGN: the third step of the data flow, used by the verb, the window and the demo. In: the pictures of a
// recording (a capture pair with dots, its plain pair, a film) and the case's scalp. Out: alignment.json and
// its files, in the case. Of several ways, the one with the smallest bound is used.

#include <string>
#include <vector>

#include "facenav/align/align_from_capture.h"
#include "facenav/capture/recording.h"
#include "facenav/casefile/case_store.h"
#include "facenav/methods/registrations.h"

namespace facenav::steps {

struct AlignOrder {
  std::string aligner;            // registered names
  std::string head_tracker = {};  // tracks the head in a film; empty: the default
  std::string matcher = stereo::kDefaultMatcher;
  std::optional<measured_face::AlignedFrom> from = {};  // only this way; nothing: the best
  /// Also tries the plain pair and the film after an accepted alignment with dots, and reports their results.
  bool tries_all = false;
  /// Accepts, with a caution, an alignment without dots whose bound is wide because neither face nor marker
  /// shows a sideways turn of a camera. Never for guidance.
  bool may_be_unsure = false;
  /// Coil whose marker may be in the pictures; empty: the recording's, else the case's (coil.json), else the
  /// default one.
  std::optional<coil_tracking::CoilModel> coil = {};
  /// A recording without a capture pair uses the pair of the case's last alignment. A confirmation of the
  /// patient that this alignment rests on holds for the same pictures.
  bool stored_pair_stands_in = false;
  /// A person checked that the case is that of the patient in view (registration::AlignmentStart).
  bool is_patient_confirmed = false;
};

/// Caution for an alignment without dots in which nothing measured a camera's turn.
inline constexpr const char* kWithoutDotsCaution =
    "aligned without dots and without the coil's marker: a camera that turned about its vertical axis is not "
    "noticed; check before each use that the coil's tip, held to nose and ears, shows there";

/// One way to align, as tried: an alignment, or the reason for its refusal.
struct AlignmentTry {
  measured_face::AlignedFrom from;
  std::optional<double> bound_mm;  // 95 %, the largest at a target; nothing: refused
  std::string refusal;
  std::optional<RigidTransform<Camera, Mri>> camera_T_mri = {};
};

struct CaseAlignment {
  AlignmentOutcome outcome;         // result of the way used
  std::vector<AlignmentTry> tries;  // dots, plain, film: those that the recording has pictures for
};

/// Aligns from the pair with dots; if its bound is wide, or without dense dots, also from the plain pair and
/// the film, and uses the one with the clearly smallest bound. An alignment without dots is accepted if the
/// coil's marker, at rest in the same pictures, measures the cameras' pose, if its bound with all unknowns is
/// small, or if the order allows an unsure one. If the best pictures show another head or moved cameras, no
/// other pictures are tried. Writes alignment.json, the map of the skin's fit and the pictures into the case.
/// Throws Error ("not aligned: ..") if no way is accepted, or if `order.from` names absent pictures;
/// registration::PersonUnclear if all that is missing is a person's confirmation. The previous alignment is
/// then unchanged.
CaseAlignment alignRecording(const Registrations& methods, const casefile::CaseStore& store,
                             const capture::Recording& recording, const AlignOrder& order,
                             TaskMonitor& monitor);

/// Writes an alignment and its files into the case: alignment.json, alignment_capture/ (photographs),
/// skin_fit.vtp and skin_fit.png. All or none, private to the user from the first byte. Throws Error; the
/// previous alignment is then unchanged.
void storeAlignment(const casefile::CaseStore& store, const cameras::StereoRig& rig,
                    const capture::CapturePair& capture, const AlignmentOutcome& outcome);

/// Returns "used the pair with dots: 95 % within 1.8 mm; the plain pair would give 95 % within 3.5 mm; the
/// film was refused: ..".
std::string inWords(const CaseAlignment& alignment);

}  // namespace facenav::steps
