#pragma once
// ALIGN: the third step of the data flow, used by the verb, the window and the demo. What a recording holds
// (a capture pair with dots, its plain pair, a film) and the case's scalp -> alignment.json and the files
// that go with it, in the case. Of several ways, the one with the smallest predicted error is used.

#include <string>
#include <vector>

#include "facenav/align/align_from_capture.h"
#include "facenav/capture/recording.h"
#include "facenav/casefile/case_store.h"
#include "facenav/methods/registrations.h"

namespace facenav::steps {

struct AlignOrder {
  std::string aligner;            // registered names
  std::string head_tracker = {};  // follows the head in a film; empty: the default
  std::string matcher = stereo::kDefaultMatcher;
  std::optional<measured_face::AlignedFrom> from = {};  // only this way; nothing: the best
  /// The plain pair and the film are tried beside dots that stand, and what they would give is told.
  bool tries_all = false;
  /// Without dots the face alone hardly shows that a camera turned sideways. Where no marker shows it either
  /// and the bound is wide, the alignment stands with a caution. Never for guidance.
  bool may_be_unsure = false;
  /// Whose marker the pictures may show; empty: the recording's, else the case's (coil.json), else the
  /// default one.
  std::optional<coil_tracking::CoilModel> coil = {};
  /// A recording without a capture pair gets the one that the case was aligned with before.
  bool stored_pair_stands_in = false;
};

/// What goes with an alignment without dots that knows nothing of a turned camera.
inline constexpr const char* kWithoutDotsCaution =
    "aligned without dots and without the coil's marker: a camera that turned about its vertical axis is not "
    "noticed; check before each use that the coil's tip, held to nose and ears, shows there";

/// One way to align, as tried: an alignment, or why not.
struct AlignmentTry {
  measured_face::AlignedFrom from;
  std::optional<double> predicted_mm, bound_mm;  // the largest at a target; nothing: refused
  std::string refusal;
  std::optional<RigidTransform<Camera, Mri>> camera_T_mri = {};
};

struct CaseAlignment {
  AlignmentOutcome outcome;         // of the way used
  std::vector<AlignmentTry> tries;  // dots, plain, film: those that the recording has pictures for
};

/// Aligns from what the recording holds: the pair with dots, else the plain pair or the film, whichever
/// predicts less error. Without dots it stands where the coil's marker, at rest in the same pictures, tells
/// how the cameras stand, where its bound with all that is unknown is small, or where it may be unsure. Where
/// the best pictures show another head or moved cameras, no other pictures are tried. Writes alignment.json,
/// the map of the skin's fit and the pictures into the case. Throws Error ("not aligned: ..") where no way
/// stands, or where `order.from` names pictures that are not there; the previous alignment is then unchanged.
CaseAlignment alignRecording(const Registrations& methods, const casefile::CaseStore& store,
                             const capture::Recording& recording, const AlignOrder& order,
                             TaskMonitor& monitor);

/// The same from a capture pair alone; it may be unsure.
AlignmentOutcome alignCase(const Registrations& methods, const casefile::CaseStore& store,
                           const cameras::StereoRig& rig, const capture::CapturePair& capture,
                           const std::string& aligner, TaskMonitor& monitor);

/// Writes an alignment and its files into the case: alignment.json, alignment_capture/ (photographs),
/// skin_fit.vtp and skin_fit.png. All or none, private to the user from the first byte. Throws Error; the
/// previous alignment is then unchanged.
void storeAlignment(const casefile::CaseStore& store, const cameras::StereoRig& rig,
                    const capture::CapturePair& capture, const AlignmentOutcome& outcome);

/// "used the pair with dots: 0.31 mm predicted; the plain pair would give 0.52 mm; the film was refused: ..".
std::string inWords(const CaseAlignment& alignment);

}  // namespace facenav::steps
