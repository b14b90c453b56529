#pragma once
// The import check: is this scan suitable for navigation by the face? One finding per topic (fine, caution or
// not usable) with the reason and advice for a new scan; and the list of face measures to compare with the
// patient. Made by prepare, stored in the case, shown before sign-off.

#include <string>
#include <vector>

#include "facenav/surface/face_measures.h"
#include "facenav/surface/scan_quality.h"

namespace facenav::surface {

enum class Verdict { fine, caution, not_usable };
/// Text: "fine", "caution", "not usable".
std::string toString(Verdict verdict);
/// Throws Error for any other text.
Verdict verdictFrom(const std::string& words);

enum class CheckTopic {
  face,
  ears,
  vertex,
  spacing,
  noise,
  ghosts,
  skin,
  wrap_around,
  left_and_right,
  scale
};
/// Name in navigation_check.json: "face", "wrap-around", "left and right", ..
std::string toString(CheckTopic topic);
/// Throws Error for any other text.
CheckTopic topicFrom(const std::string& words);

struct CheckFinding {
  CheckTopic topic = CheckTopic::face;
  Verdict verdict = Verdict::fine;
  std::string finding;  // what was found and why it matters
  std::string ask;      // what to request from the scanner's staff; may be empty
};

struct NavigationCheck {
  std::vector<CheckFinding> findings;
  FaceLandmarks landmarks;
  std::vector<FaceMeasure> measures;

  /// The worst verdict of all findings.
  Verdict verdict() const;
};

/// One line: "noise, caution: .. ; ask for ..".
std::string inWords(const CheckFinding& finding);

/// Checks a scan. `head`: the head's mask on the grid of `mri`; `scalp`: its skin. Takes a second or two.
NavigationCheck checkForNavigation(const volume::Volume& mri, const volume::Mask& head,
                                   const ScalpSurface& scalp);

}  // namespace facenav::surface
