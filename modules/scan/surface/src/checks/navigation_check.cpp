#include "facenav/surface/navigation_check.h"

#include <algorithm>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/volume/voxel_size.h"

namespace facenav::surface {
namespace {

constexpr const char* kThinSlices = "a 3-D T1 (MPRAGE, BRAVO, TFE) with voxels of 1 mm, at most 1.2 mm";
constexpr const char* kWholeHead =
    "a field of view from above the vertex to below the chin, with 10 mm of air around nose and ears";

double cutArea_mm2(const ScanQuality& scan, const std::string& name) {
  for (const ScanSide& side : scan.sides)
    if (side.name == name) return side.cut_area_mm2;
  return 0;
}

CheckFinding checkFacePresence(const ScalpSurface& scalp) {
  std::string words;
  const std::size_t of_face = scalp.findings.size() - (scalp.has_cut_ear ? 1 : 0);
  for (std::size_t i = 0; i < of_face; ++i) words += (i == 0 ? "" : "; ") + scalp.findings[i];
  if (!scalp.has_face)
    return {CheckTopic::face, Verdict::not_usable, words.empty() ? "there is no face to align to" : words,
            (words.find("defaced") == std::string::npos ? "" : "the original, not defaced images; ") +
                std::string(kWholeHead)};
  if (!words.empty()) return {CheckTopic::face, Verdict::caution, words, kWholeHead};
  return {CheckTopic::face, Verdict::fine, "brow, eyes and nose are there, whole", ""};
}

CheckFinding checkEars(const ScanQuality& scan) {
  constexpr double kEar_mm2 = 30;
  const bool right = cutArea_mm2(scan, "right") > kEar_mm2, left = cutArea_mm2(scan, "left") > kEar_mm2;
  if (!right && !left) return {CheckTopic::ears, Verdict::fine, "both ears lie within the field of view", ""};
  return {
      CheckTopic::ears, Verdict::caution,
      std::string(right && left ? "both sides of the head are"
                  : right       ? "the right side of the head is"
                                : "the left side of the head is") +
          " cut by the field of view: no measure over the ears, and targets far to the side lack their scalp",
      kWholeHead};
}

CheckFinding checkVertex(const ScanQuality& scan) {
  constexpr double kTouch_mm2 = 30, kMuch_mm2 = 1500;
  const double cut_mm2 = cutArea_mm2(scan, "top");
  if (cut_mm2 < kTouch_mm2)
    return {CheckTopic::vertex, Verdict::fine, "the top of the head lies within the field of view", ""};
  return {CheckTopic::vertex, cut_mm2 < kMuch_mm2 ? Verdict::caution : Verdict::not_usable,
          formatted("the top of the head is cut over %.0f cm2: targets there have no scalp", cut_mm2 / 100),
          kWholeHead};
}

CheckFinding checkSpacing(const ScanQuality& scan) {
  const std::string words =
      formatted("voxels of %.2f to %.2f mm", scan.smallest_voxel_mm, scan.largest_voxel_mm);
  const auto size = volume::voxelSizeOf(scan.largest_voxel_mm);
  if (size == volume::VoxelSize::fine) return {CheckTopic::spacing, Verdict::fine, words, ""};
  const bool is_usable = size == volume::VoxelSize::coarse;
  return {CheckTopic::spacing, is_usable ? Verdict::caution : Verdict::not_usable,
          words + (is_usable ? ": the skin is placed less well than with 1 mm"
                             : ": too coarse to place skin or cortex"),
          kThinSlices};
}

CheckFinding checkNoise(const ScanQuality& scan) {
  constexpr double kFine_mm = 0.15, kUsable_mm = 0.5;
  if (scan.is_air_blanked)
    return {CheckTopic::noise, Verdict::fine,
            "not measurable, the air around the head was erased; the skin's edge is clear", ""};
  if (scan.noise <= 0)
    return {CheckTopic::noise, Verdict::caution, "not measurable, the scan holds no air beside the head",
            kWholeHead};
  const std::string words = formatted("the noise moves the skin by %.2f mm (signal to noise %.0f)",
                                      scan.skin_jitter_mm, scan.skin_step / scan.noise);
  if (scan.skin_jitter_mm <= kFine_mm) return {CheckTopic::noise, Verdict::fine, words, ""};
  return {CheckTopic::noise, scan.skin_jitter_mm <= kUsable_mm ? Verdict::caution : Verdict::not_usable,
          words, "a head coil with more channels, less acceleration, or two averages"};
}

CheckFinding checkGhosts(const ScanQuality& scan) {
  constexpr double kFine = 0.02,
                   kUsable = 0.08;  // relative to the skin's step; the ACR's limit in phantoms is 0.025
  if (scan.is_air_signed)
    return {CheckTopic::ghosts, Verdict::fine,
            "not measurable, this is a CT or its air holds negative values", ""};
  if (!scan.has_ghost_measure)
    return {CheckTopic::ghosts, Verdict::fine, "not measurable, there is no untouched air beside the head",
            ""};
  const std::string words =
      formatted("ghosts in the air beside the head reach %.1f %% of the skin's signal",
                100 * scan.ghost_share) +
      (scan.ghost_share > kFine ? " (" + scan.ghost_direction + "): the head moved, or an artefact" : "");
  if (scan.ghost_share <= kFine) return {CheckTopic::ghosts, Verdict::fine, words, ""};
  return {CheckTopic::ghosts, scan.ghost_share <= kUsable ? Verdict::caution : Verdict::not_usable, words,
          "the scan again, head padded still, phase encoding left-right so that ghosts miss the face"};
}

/// Area of the upper head (where coils go) whose skin is uncertain by more than half a millimetre.
double unsureArea_mm2(const ScalpSurface& scalp) {
  constexpr double kUnsure_mm = 0.5, kUpper_mm = 110;
  if (scalp.doubt_mm.size() != scalp.mesh.vertices_mm.size()) return 0;
  double top_mm = -1e9, area_mm2 = 0;
  for (const auto& p : scalp.mesh.vertices_mm) top_mm = std::max(top_mm, p.z());
  for (const auto& t : scalp.mesh.triangles) {
    const auto& p = scalp.mesh.vertices_mm;
    if (scalp.doubt_mm[t[0]] < kUnsure_mm || p[t[0]].z() < top_mm - kUpper_mm) continue;
    area_mm2 += 0.5 * (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]).norm();
  }
  return area_mm2;
}

CheckFinding checkSkin(const ScalpSurface& scalp) {
  constexpr double kMuch_mm2 = 1500;
  const double unsure_mm2 = unsureArea_mm2(scalp);
  if (unsure_mm2 < kMuch_mm2)
    return {CheckTopic::skin, Verdict::fine, "it ends in dark air where coils go", ""};
  return {CheckTopic::skin, Verdict::caution,
          formatted(
              "over %.0f cm2 of the upper head the skin is unsure by more than 0.5 mm, and so is the coil's "
              "gap: pads, earphones or haze lie against it, or its edge is drawn out",
              unsure_mm2 / 100),
          "a scan with nothing but air at forehead and crown, or pads without signal"};
}

CheckFinding checkWrapping(const ScanQuality& scan) {
  constexpr double kShare = 0.2;
  std::string places;
  bool is_of_face = false;
  for (const ScanSide& side : scan.sides) {
    if (side.wrapped_share <= kShare && !side.is_wrapped) continue;
    places += (places.empty() ? "the " : " and the ") + side.name +
              formatted(" (%.0f %% of what is cut opposite)", 100 * side.wrapped_share);
    is_of_face |= side.name == "front" || side.name == "back";
  }
  if (places.empty())
    return {CheckTopic::wrap_around, Verdict::fine, "nothing appears on the wrong side of the scan", ""};
  return {CheckTopic::wrap_around, Verdict::caution,
          "tissue of the opposite side appears at " + places + " of the scan" +
              (is_of_face ? ": the face may be cut or covered, look at the skin of face and back" : ""),
          "phase oversampling, or a larger field of view"};
}

CheckFinding checkLeftRight(const volume::Volume& mri) {
  if (mri.orientation_source == "DICOM")
    return {CheckTopic::left_and_right, Verdict::fine,
            "rest on Image Position and Orientation (Patient), as the scanner wrote them; a wrong patient "
            "position "
            "entered at the scanner cannot be seen here",
            ""};
  return {CheckTopic::left_and_right, Verdict::caution,
          "rest on the file's " + mri.orientation_source +
              ", which any program on the way may have changed: compare a mole, a scar or the parting with "
              "the person",
          "the DICOM images, or a capsule taped to the right temple"};
}

CheckFinding checkScale(const std::vector<FaceMeasure>& measures) {
  std::string unusual;
  int count = 0;
  for (const auto& measure : measures)
    if (!measure.isUsual()) {
      ++count;
      unusual += (unusual.empty() ? "" : ", ") + measure.name + formatted(" %.0f mm", measure.value_mm);
    }
  if (measures.empty())
    return {CheckTopic::scale, Verdict::caution,
            "no landmark was found, so nothing can be held against the person", kWholeHead};
  if (count == 0)
    return {CheckTopic::scale, Verdict::fine,
            std::to_string(measures.size()) + " measures of face and head lie within the adult range", ""};
  return {CheckTopic::scale, Verdict::caution,
          "outside the adult range: " + unusual +
              "; a child, another population, a template head or a wrong voxel size: measure the person",
          ""};
}

}  // namespace

std::string toString(Verdict verdict) {
  return verdict == Verdict::fine ? "fine" : verdict == Verdict::caution ? "caution" : "not usable";
}

Verdict verdictFrom(const std::string& words) {
  for (const Verdict verdict : {Verdict::fine, Verdict::caution, Verdict::not_usable})
    if (toString(verdict) == words) return verdict;
  throw Error("is no verdict (fine, caution, not usable)", words);
}

std::string toString(CheckTopic topic) {
  switch (topic) {
    case CheckTopic::face:
      return "face";
    case CheckTopic::ears:
      return "ears";
    case CheckTopic::vertex:
      return "vertex";
    case CheckTopic::spacing:
      return "spacing";
    case CheckTopic::noise:
      return "noise";
    case CheckTopic::ghosts:
      return "ghosts";
    case CheckTopic::skin:
      return "skin";
    case CheckTopic::wrap_around:
      return "wrap-around";
    case CheckTopic::left_and_right:
      return "left and right";
    case CheckTopic::scale:
      return "scale";
  }
  return {};
}

CheckTopic topicFrom(const std::string& words) {
  for (int i = 0; i <= int(CheckTopic::scale); ++i) {  // scale is the last one
    const auto topic = CheckTopic(i);
    if (toString(topic) == words) return topic;
  }
  throw Error("is no topic of the import check", words);
}

std::string inWords(const CheckFinding& finding) {
  return toString(finding.topic) + ", " + toString(finding.verdict) + ": " + finding.finding +
         (finding.ask.empty() ? "" : "; ask for " + finding.ask);
}

Verdict NavigationCheck::verdict() const {
  Verdict worst = Verdict::fine;
  for (const auto& finding : findings) worst = std::max(worst, finding.verdict);
  return worst;
}

NavigationCheck checkForNavigation(const volume::Volume& mri, const volume::Mask& head,
                                   const ScalpSurface& scalp) {
  FACENAV_EXPECT(head.grid.size == mri.grid.size, "mask and volume differ in size");
  const ScanQuality scan = measureScan(mri, head, scalp.mesh);
  NavigationCheck check;
  if (scalp.has_face) {
    check.landmarks = findFaceLandmarks(scalp);
    check.measures = measureFace(check.landmarks, scan.largest_voxel_mm);
  }
  check.findings = {checkFacePresence(scalp),  checkEars(scan),     checkVertex(scan),
                    checkSpacing(scan),        checkNoise(scan),    checkGhosts(scan),
                    checkSkin(scalp),          checkWrapping(scan), checkLeftRight(mri),
                    checkScale(check.measures)};
  return check;
}

}  // namespace facenav::surface
