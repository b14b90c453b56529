#pragma once
// The import check: is this scan fit for navigation by the face? One finding a topic, each fine, caution or
// not usable, with the reason, and what to ask the scanner for; and the sheet of face measures to hold
// against the person. Made by prepare, kept in the case, shown before sign-off.

#include <string>
#include <vector>

#include "facenav/surface/face_measures.h"
#include "facenav/surface/scan_quality.h"

namespace facenav::surface {

enum class Verdict { fine, caution, not_usable };
/// "fine", "caution", "not usable".
std::string toString(Verdict verdict);
/// Throws Error for another word.
Verdict verdictFrom(const std::string& words);

struct CheckFinding {
  std::string topic;  // "face", "ears", "vertex", "spacing", "noise", "ghosts", "wrap-around", "left and
                      // right", "scale"
  Verdict verdict = Verdict::fine;
  std::string finding;  // what was found and why it matters
  std::string ask;      // what to ask the scanner for; empty where nothing
};

struct NavigationCheck {
  std::vector<CheckFinding> findings;
  FaceLandmarks landmarks;
  std::vector<FaceMeasure> measures;

  /// The worst of all findings.
  Verdict verdict() const;
};

/// "noise, caution: .. ; ask for ..".
std::string inWords(const CheckFinding& finding);

/// `head`: the head's mask on the grid of `mri`; `scalp`: its skin. A second or two.
NavigationCheck checkForNavigation(const volume::Volume& mri, const volume::Mask& head,
                                   const ScalpSurface& scalp);

}  // namespace facenav::surface
