#include "facenav/plan/case_landmarks.h"

#include <chrono>
#include <cmath>

#include "facenav/casefile/landmarks_file.h"
#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/core/utc_time.h"
#include "facenav/surface/closest_point.h"

namespace facenav::steps {
namespace {

using surface::Landmark;
using surface::LandmarkSource;
using surface::ScalpLandmark;

/// Landmark on the skin of Colin27, MNI mm, from the standard 10-05 positions (Oostenveld and Praamstra 2001,
/// file standard_1005.elc).
Point<Mni> templateLandmark(Landmark which) {
  switch (which) {
    case Landmark::nasion:
      return {0.0, 86.8, -40.0};
    case Landmark::inion:
      return {0.0, -118.6, -23.1};
    case Landmark::tragus_left:
      return {-86.1, -20.0, -48.0};
    case Landmark::tragus_right:
      return {85.8, -20.0, -48.0};
  }
  FACENAV_EXPECT(false, "unknown landmark");
}

/// Standard error through the atlas, by judgement: it is fitted to the brain alone, and the face and the
/// skull's base lie outside it.
constexpr double kThroughAtlas_mm = 8.0;
/// Standard error of a person who clicks on a slice or types.
constexpr double kByHand_mm = 2.0;
constexpr double kFurthestFromSkin_mm = 20.0;

bool isOnEdge(const surface::ScalpSurface& scalp, const Point<Mri>& p) {
  constexpr double kAtEdge_mm = 2.0;
  for (const auto& [on_plane, outwards] : scalp.field_of_view)
    if (outwards.v.dot(p.mm - on_plane.mm) > -kAtEdge_mm) return true;
  return false;
}

}  // namespace

surface::ScalpLandmarks findLandmarks(const surface::ScalpSurface& scalp, const atlas::AtlasMap* atlas) {
  surface::ScalpLandmarks landmarks = surface::findScalpLandmarks(scalp);
  if (!atlas) return landmarks;
  const surface::ClosestPoint skin(scalp.mesh);
  for (const Landmark which : surface::kLandmarks) {
    const auto place = skin.nearest(atlas->toMri(templateLandmark(which)));
    const double sd_mm = std::hypot(kThroughAtlas_mm, place.distance_mm);
    if (landmarks[which] && landmarks[which]->sd_mm <= sd_mm) continue;
    landmarks[which] =
        ScalpLandmark{place.point, sd_mm, LandmarkSource::atlas, isOnEdge(scalp, place.point), {}, {}};
  }
  return landmarks;
}

surface::ScalpLandmarks landmarksOf(const casefile::CaseStore& store, const surface::ScalpSurface& scalp) {
  if (const auto kept = casefile::readLandmarks(store.folder())) return *kept;
  const auto atlas = store.atlas();
  const auto landmarks = findLandmarks(scalp, atlas ? &*atlas : nullptr);
  casefile::writeLandmarks(landmarks, store.folder());
  return landmarks;
}

surface::ScalpLandmarks setLandmark(const casefile::CaseStore& store, const surface::ScalpSurface& scalp,
                                    Landmark which, const Point<Mri>& p, const std::string& by) {
  const auto place = surface::ClosestPoint(scalp.mesh).nearest(p);
  if (!(place.distance_mm <= kFurthestFromSkin_mm))
    throw Error(formatted("the place lies %.0f mm from the skin", place.distance_mm), toString(which),
                "choose a place on the skin");
  auto landmarks = landmarksOf(store, scalp);
  landmarks[which] = ScalpLandmark{place.point,
                                   kByHand_mm,
                                   LandmarkSource::hand,
                                   isOnEdge(scalp, place.point),
                                   isoUtc(std::chrono::system_clock::now()),
                                   by};
  casefile::writeLandmarks(landmarks, store.folder());
  return landmarks;
}

surface::ScalpLandmarks findLandmarkAgain(const casefile::CaseStore& store,
                                          const surface::ScalpSurface& scalp, Landmark which) {
  auto landmarks = landmarksOf(store, scalp);
  const auto atlas = store.atlas();
  landmarks[which] = findLandmarks(scalp, atlas ? &*atlas : nullptr)[which];
  casefile::writeLandmarks(landmarks, store.folder());
  return landmarks;
}

}  // namespace facenav::steps
