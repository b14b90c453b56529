#include "facenav/surface/scalp_landmarks.h"

#include <algorithm>

#include "facenav/core/error.h"
#include "facenav/surface/face_landmarks.h"

namespace facenav::surface {
namespace {

struct LandmarkNames {
  Landmark landmark;
  const char* word;        ///< name in files, commands and on the screen
  const char* anatomical;  ///< the anthropometric name in FaceLandmarks
};

constexpr LandmarkNames kNames[] = {{Landmark::nasion, "nasion", "nasion"},
                                    {Landmark::inion, "inion", "inion"},
                                    {Landmark::tragus_left, "tragus-left", "tragion L"},
                                    {Landmark::tragus_right, "tragus-right", "tragion R"}};

const LandmarkNames& namesOf(Landmark landmark) {
  for (const auto& names : kNames)
    if (names.landmark == landmark) return names;
  FACENAV_EXPECT(false, "unknown landmark");
}

}  // namespace

std::string toString(Landmark landmark) { return namesOf(landmark).word; }

Landmark landmarkFrom(const std::string& word) {
  for (const Landmark landmark : kLandmarks)
    if (toString(landmark) == word) return landmark;
  throw Error("there is no landmark '" + word + "'", {}, "choose nasion, inion, tragus-left or tragus-right");
}

std::string toString(LandmarkSource source) {
  switch (source) {
    case LandmarkSource::skin:
      return "skin";
    case LandmarkSource::atlas:
      return "atlas";
    case LandmarkSource::hand:
      return "hand";
  }
  FACENAV_EXPECT(false, "unknown source");
}

LandmarkSource landmarkSourceFrom(const std::string& word) {
  for (const auto source : {LandmarkSource::skin, LandmarkSource::atlas, LandmarkSource::hand})
    if (toString(source) == word) return source;
  throw Error("'" + word + "' is no source of a landmark: skin, atlas or hand was expected");
}

bool ScalpLandmarks::isComplete() const {
  return std::all_of(all_.begin(), all_.end(), [](const auto& landmark) { return landmark.has_value(); });
}

const ScalpLandmark& ScalpLandmarks::known(Landmark which) const {
  if (const auto& landmark = (*this)[which]) return *landmark;
  throw Error("the " + toString(which) + " is not known", {},
              "set it by hand: in Plan at the crosshair, or facenav plan CASE --set-landmark " +
                  toString(which) + "=X,Y,Z");
}

ScalpLandmarks findScalpLandmarks(const ScalpSurface& scalp) {
  if (!scalp.has_face) return {};  // a defaced scan shows false ones
  const FaceLandmarks face = findFaceLandmarks(scalp);
  ScalpLandmarks found;
  for (const Landmark landmark : kLandmarks)
    if (const auto f = face.find(namesOf(landmark).anatomical))
      found[landmark] = ScalpLandmark{f->point, f->sd_mm, LandmarkSource::skin, f->is_cut, {}, {}};
  return found;
}

}  // namespace facenav::surface
