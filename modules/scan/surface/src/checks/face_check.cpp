#include "face_check.h"

#include <algorithm>
#include <cmath>

#include "facenav/anatomy/face_norms.h"
#include "facenav/core/robust_statistics.h"
#include "facenav/geometry/rotation.h"
#include "landmarks/head_frame.h"

namespace facenav::surface {
namespace {

using anatomy::FaceMatch;
using anatomy::SkinRelief;
using Eigen::Vector3d;

constexpr double kFaceDepth_mm =
    110;  // skin further behind the foremost is the head's back, seen through a hole

/// The skin in the head's own axes, and its relief from the front.
struct HeadFront {
  Eigen::Isometry3d head_from_mri;
  std::vector<Vector3d> head_mm;
  SkinRelief relief;
  double top_mm = -1e9, foremost_mm = -1e9;

  HeadFront(const TriangleMesh& scalp, const Eigen::Isometry3d& frame) : head_from_mri(frame) {
    for (const Vector3d& v : scalp.vertices_mm) {
      head_mm.push_back(head_from_mri * v);
      top_mm = std::max(top_mm, head_mm.back().z());
      foremost_mm = std::max(foremost_mm, head_mm.back().y());
    }
    relief = anatomy::reliefFrom(anatomy::Side::front, head_mm, scalp.triangles);
    for (float& height : relief.height_mm)
      if (height < foremost_mm - kFaceDepth_mm) height = SkinRelief::kNone;
  }
};

/// The head's front and the face on it. Where no face is clear, also with the head nodded: a head that nods
/// back shows the scan's lower end, which hides the likeness.
std::pair<HeadFront, std::optional<FaceMatch>> findFront(const TriangleMesh& scalp) {
  constexpr double kNods_deg[] = {-12, 12};
  const Eigen::Isometry3d level = symmetryFrame(scalp);
  HeadFront front(scalp, level);
  auto face = anatomy::findFace(front.relief, front.top_mm);
  if (face && face->likeness >= anatomy::kClearFaceLikeness) return {std::move(front), face};
  for (const double nod_deg : kNods_deg) {
    HeadFront nodding(scalp, Eigen::AngleAxisd(nod_deg * kRadPerDeg, Vector3d::UnitX()) * level);
    const auto found = anatomy::findFace(nodding.relief, nodding.top_mm);
    if (found && anatomy::kFaceLikeness.contains(found->likeness) &&
        (!face || found->likeness > face->likeness))
      front = std::move(nodding), face = found;
  }
  return {std::move(front), face};
}

/// Box of the face (brow to upper lip) or of the forehead, in the relief's axes.
Eigen::AlignedBox2d boxOf(const FaceMatch& face, double lowest_mm, double highest_mm) {
  constexpr double kAside_mm = 40;
  const double s = face.scale;
  return {Eigen::Vector2d(face.x_mm - s * kAside_mm, face.nasion_mm + s * lowest_mm),
          Eigen::Vector2d(face.x_mm + s * kAside_mm, face.nasion_mm + s * highest_mm)};
}
Eigen::AlignedBox2d faceBox(const FaceMatch& face) { return boxOf(face, -55, 15); }
Eigen::AlignedBox2d foreheadBox(const FaceMatch& face) { return boxOf(face, 28, 60); }

std::optional<double> detailOf(const HeadFront& front, const FaceMatch& face) {
  const SkinRelief relief = anatomy::smoothed(front.relief, 1.0);
  const auto of_face = anatomy::fineRelief_mm(relief, faceBox(face)),
             of_forehead = anatomy::fineRelief_mm(relief, foreheadBox(face));
  if (!of_face || !of_forehead || *of_forehead <= 0) return std::nullopt;
  return *of_face / *of_forehead;
}

std::optional<double> edgeWidthOf(const HeadFront& front, const FaceMatch& face,
                                  const std::vector<float>& edge_width_mm) {
  constexpr double kAboveBrow_mm = 25, kFacing_mm = 70;
  constexpr std::size_t kEnough = 200;
  const Eigen::AlignedBox2d box = faceBox(face);
  std::vector<float> of_face, of_rest;
  for (std::size_t v = 0; v < edge_width_mm.size(); ++v) {
    const Vector3d& p = front.head_mm[v];
    if (face.aboveNasion_mm(p.z()) > kAboveBrow_mm)
      of_rest.push_back(edge_width_mm[v]);
    else if (p.y() > front.foremost_mm - kFacing_mm && box.contains(Eigen::Vector2d(p.x(), p.z())))
      of_face.push_back(edge_width_mm[v]);
  }
  if (of_face.size() < kEnough || of_rest.size() < kEnough) return std::nullopt;
  return double(upperMedian(std::move(of_face))) / std::max(1e-3, double(upperMedian(std::move(of_rest))));
}

/// The lowest skin of the face, between the cheeks.
double lowestFace_mm(const HeadFront& front, double x_mm) {
  constexpr int kCheek_mm = 30;
  const SkinRelief& relief = front.relief;
  for (int row = 0; row < relief.rows; ++row) {
    int cells = 0;
    for (int x = -kCheek_mm; x <= kCheek_mm; ++x)
      cells += relief.cell(int(std::lround(x_mm - relief.left_mm)) + x, row) > SkinRelief::kNone;
    if (cells > kCheek_mm) return relief.bottom_mm + row;
  }
  return relief.bottom_mm + relief.rows;
}

/// The foremost skin of the forehead.
double forehead_mm(const HeadFront& front) {
  constexpr double kHighest_mm = 30, kLowest_mm = 70;
  double foremost_mm = -1e9;
  for (const Vector3d& p : front.head_mm)
    if (p.z() < front.top_mm - kHighest_mm && p.z() > front.top_mm - kLowest_mm)
      foremost_mm = std::max(foremost_mm, p.y());
  return foremost_mm;
}

/// Parts of the face that the scan's ends cut.
struct Cuts {
  int at_nose = 0, at_ear = 0, at_forehead = 0;
  Eigen::AlignedBox3d hole_mm;  // in the head's axes, cut by ends in front of the face
};
Cuts findCuts(const HeadFront& front, const MeshNeighbours& neighbours, const ScanEnds& ends, double x_mm,
              double nasion_mm) {
  constexpr double kOnEnd_mm = 1.5, kAlong = 0.7, kNose_mm = 60, kHalfNose_mm = 22, kEar_mm = 30,
                   kCheek_mm = 60;
  Cuts cuts;
  for (const auto& [point, out] : ends) {
    const Vector3d normal = front.head_from_mri.linear() * out.v, on_end = front.head_from_mri * point.mm;
    if (normal.y() < kAlong && std::abs(normal.x()) < kAlong) continue;
    for (std::size_t v = 0; v < front.head_mm.size(); ++v) {
      const Vector3d& p = front.head_mm[v];
      if (!neighbours.on_border[v] || normal.dot(p - on_end) < -kOnEnd_mm) continue;
      if (normal.y() < kAlong) {
        cuts.at_ear += p.z() < nasion_mm + kEar_mm;
        continue;
      }
      cuts.at_forehead += p.z() > nasion_mm;
      cuts.at_nose +=
          std::abs(p.x() - x_mm) < kHalfNose_mm && p.z() < nasion_mm && p.z() > nasion_mm - kNose_mm;
      if (std::abs(p.x() - x_mm) < kCheek_mm) cuts.hole_mm.extend(p);
    }
  }
  return cuts;
}

/// Describes how much of the face lies above the scan's lower end; empty for a whole face.
std::string describeEnd(const HeadFront& front, const FaceMatch& face) {
  constexpr double kNoseBase_mm = 45, kLip_mm = 70, kChin_mm = 95;
  const double below_mm = -face.aboveNasion_mm(lowestFace_mm(front, face.x_mm));
  const std::string rest = ", points of the face below are not used";
  if (below_mm < kNoseBase_mm)
    return "the scan ends at mid-nose: alignment rests on forehead, brow and eyes" + rest;
  if (below_mm < kLip_mm) return "the scan ends at the upper lip" + rest;
  return below_mm < kChin_mm ? "the scan ends above the chin" + rest : "";
}

/// Reason why there is no face to align to; empty if there is one.
std::string describeLack(FaceState state) {
  switch (state) {
    case FaceState::removed:
      return "the face was removed below the brow (a defaced scan): there is no face to align to";
    case FaceState::blurred:
      return "the face was blurred or smoothed by a program (a defaced scan): its skin is not the person's";
    case FaceState::cut_off:
      return "the scan's edge cuts the face off: there is no face to align to";
    case FaceState::not_in_scan:
      return "the scan ends above the nose: there is no face to align to";
    default:
      return "";
  }
}

}  // namespace

FaceState judgeFace(const FaceEvidence& e) {
  // No face is 50 mm wide and high so far in front of the forehead: noise in a removed face's place may be.
  constexpr double kNose_mm = 140, kFaceCut_mm = 50, kAhead_mm = 20;
  const double likeness = e.match ? e.match->likeness : 0;
  if (!anatomy::kFaceLikeness.contains(likeness)) {
    if (e.height_mm < kNose_mm) return FaceState::not_in_scan;
    const bool is_cut = e.cut_mm > kFaceCut_mm && e.cut_ahead_mm < kAhead_mm;
    return is_cut ? FaceState::cut_off : FaceState::removed;
  }
  const double width = e.edge_width.value_or(1), detail = e.detail.value_or(anatomy::kFaceDetail.low);
  const bool is_smooth = !anatomy::kFaceDetail.contains(detail),
             is_flat = !anatomy::kFaceStrength.contains(e.match->strength);
  if (!anatomy::kFaceEdge.contains(width) || (is_smooth && is_flat)) return FaceState::blurred;
  const bool is_clear =
      likeness >= anatomy::kClearFaceLikeness && width <= anatomy::kClearFaceEdge && !is_smooth;
  return is_clear ? FaceState::whole : FaceState::unclear;
}

FaceCheck checkFace(const TriangleMesh& scalp, const MeshNeighbours& neighbours, const ScanEnds& ends,
                    const std::vector<float>& edge_width_mm) {
  const auto [front, match] = findFront(scalp);
  FaceCheck check;
  FaceEvidence& evidence = check.evidence;
  evidence.match = match;
  const FaceMatch face = evidence.match.value_or(FaceMatch{});
  const Cuts cuts = findCuts(front, neighbours, ends, face.x_mm, face.nasion_mm);
  if (!cuts.hole_mm.isEmpty()) {
    evidence.cut_mm = std::min(cuts.hole_mm.sizes().x(), cuts.hole_mm.sizes().z());
    evidence.cut_ahead_mm = cuts.hole_mm.center().y() - forehead_mm(front);
  }
  evidence.height_mm = front.top_mm - lowestFace_mm(front, face.x_mm);
  if (evidence.match) {
    evidence.detail = detailOf(front, face);
    evidence.edge_width = edgeWidthOf(front, face, edge_width_mm);
  }
  check.state = judgeFace(evidence);
  if (const std::string lack = describeLack(check.state); !lack.empty()) {
    check.findings.push_back(lack);
    return check;
  }
  check.has_face = true;
  if (check.state == FaceState::unclear)
    check.findings.push_back(
        "brow, eyes and nose are hard to make out (partly removed, smoothed or unusual): look at the skin "
        "before "
        "aligning");
  if (const std::string end = describeEnd(front, face); !end.empty()) check.findings.push_back(end);
  if (cuts.at_nose > 5) check.findings.push_back("the nose tip is cut by the scan's edge");
  if (cuts.at_forehead > 5) check.findings.push_back("the forehead touches the scan's edge");
  check.has_cut_ear = cuts.at_ear > 10;
  if (check.has_cut_ear) check.findings.push_back("an ear is cut by the scan's edge");
  return check;
}

}  // namespace facenav::surface
