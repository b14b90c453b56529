#pragma once
// The four places that measures of the head start from: nasion, inion, and both tragi (the preauricular
// points of the 10-20 system). Each has its source and its standard error.

#include <array>
#include <optional>
#include <string>

#include "facenav/surface/scalp_surface.h"

namespace facenav::surface {

enum class Landmark { nasion, inion, tragus_left, tragus_right };  // the patient's left and right
inline constexpr std::array<Landmark, 4> kLandmarks{Landmark::nasion, Landmark::inion, Landmark::tragus_left,
                                                    Landmark::tragus_right};
/// Name: "nasion", "inion", "tragus-left", "tragus-right".
std::string toString(Landmark landmark);
/// Landmark of that name. Throws Error that lists the names for another word.
Landmark landmarkFrom(const std::string& word);

enum class LandmarkSource {
  skin,   // found by its shape
  atlas,  // the template's landmark, carried to this head by the atlas and put on its skin
  hand    // set by a person
};
std::string toString(LandmarkSource source);
/// Source of that name. Throws Error for another word.
LandmarkSource landmarkSourceFrom(const std::string& word);

struct ScalpLandmark {
  Point<Mri> point;
  double sd_mm = 0;  // standard error, along the skin
  LandmarkSource source = LandmarkSource::skin;
  bool is_cut = false;  // on the scan's edge: the true place may lie outside
  std::string utc, by;  // if set by hand: when, by whom
};

/// The known landmarks.
class ScalpLandmarks {
 public:
  const std::optional<ScalpLandmark>& operator[](Landmark which) const { return all_[std::size_t(which)]; }
  std::optional<ScalpLandmark>& operator[](Landmark which) { return all_[std::size_t(which)]; }
  bool isComplete() const;
  /// Returns a known landmark. Throws Error with advice on setting it if it is not known.
  const ScalpLandmark& known(Landmark which) const;

 private:
  std::array<std::optional<ScalpLandmark>, 4> all_;
};

/// Finds the landmarks that the skin's shape shows: none without a face, no tragi where the scan cuts the
/// ears. Takes about a second.
ScalpLandmarks findScalpLandmarks(const ScalpSurface& scalp);

}  // namespace facenav::surface
