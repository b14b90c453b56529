#include "facenav/anatomy/midline_profile.h"

#include <algorithm>
#include <cmath>

#include "facenav/geometry/rotation.h"

namespace facenav::anatomy {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kBins = 1080;  // directions in the full turn about a point inside the cranium

/// Points (front, up) where the plane x = 0 cuts the triangles' edges.
std::vector<Vector2d> cutPoints(const std::vector<Vector3d>& head_mm,
                                const std::vector<Eigen::Vector3i>& triangles) {
  std::vector<Vector2d> points;
  for (const auto& t : triangles) {
    std::vector<Vector2d> ends;
    for (int k = 0; k < 3; ++k) {
      const Vector3d &a = head_mm[std::size_t(t[k])], &b = head_mm[std::size_t(t[(k + 1) % 3])];
      if ((a.x() < 0) == (b.x() < 0)) continue;
      const Vector3d p = a + (b - a) * (a.x() / (a.x() - b.x()));
      ends.push_back(p.tail<2>());
    }
    if (ends.size() == 2) points.insert(points.end(), {ends[0], 0.5 * (ends[0] + ends[1]), ends[1]});
  }
  return points;
}

/// The outermost point in each direction from `centre`, starting straight up, towards the front (`direction`
/// +1) or back (-1). Stops at a gap of more than 20 degrees: the end of the scan.
Outline outermost(const std::vector<Vector2d>& points, const Vector2d& centre, int direction) {
  std::vector<std::optional<Vector2d>> best(kBins / 2);
  for (const Vector2d& p : points) {
    const Vector2d r = p - centre;
    const double turn = direction * std::atan2(r.x(), r.y()) / (2 * M_PI);  // 0 up, 0.25 to the front
    if (turn < 0) continue;
    auto& bin = best[std::min(best.size() - 1, std::size_t(turn * kBins))];
    if (!bin || (*bin - centre).norm() < r.norm()) bin = p;
  }
  Outline outline;
  int gap = 0;
  for (const auto& bin : best) {
    gap = bin ? 0 : gap + 1;
    if (gap > kBins / 18) break;
    if (bin) outline.push_back(*bin);
  }
  return outline;
}

/// Points `step_mm` apart along the line, lightly smoothed.
Outline evenly(const Outline& line, double step_mm) {
  Outline even;
  if (line.size() < 5) return even;
  Vector2d last = line.front();
  even.push_back(last);
  for (std::size_t i = 1; i < line.size(); ++i)
    while ((line[i] - last).norm() >= step_mm)
      even.push_back(last += step_mm * (line[i] - last).normalized());
  Outline smooth = even;
  for (std::size_t i = 2; i + 2 < even.size(); ++i)
    smooth[i] = (even[i - 2] + 2 * even[i - 1] + 3 * even[i] + 2 * even[i + 1] + even[i + 2]) / 9;
  return smooth;
}

constexpr double kStep_mm = 0.7;
constexpr double kCrown_mm = 60;  // no nose this near to the outline's start
int steps(double mm) { return int(std::lround(mm / kStep_mm)); }

/// Distance of `p` from the line a-b towards its outer side, for a line that runs down the face.
double outwards(const Vector2d& p, const Vector2d& a, const Vector2d& b) {
  const Vector2d along = (b - a).normalized();
  return Vector2d(-along.y(), along.x()).dot(p - a);
}

/// The point of [from, to) furthest from the line a-b: outwards (sign 1) or inwards (-1). nullopt below
/// `least_mm`.
std::optional<int> furthest(const Outline& line, int from, int to, const Vector2d& a, const Vector2d& b,
                            double sign, double least_mm) {
  std::optional<int> best;
  for (int i = std::max(0, from); i < std::min(to, int(line.size())); ++i)
    if (const double here = sign * outwards(line[std::size_t(i)], a, b); here > least_mm)
      least_mm = here, best = i;
  return best;
}

/// Height of each point above a chord of a nose's length; the chord is shorter at the outline's ends.
std::vector<double> prominences(const Outline& line) {
  constexpr double kReach_mm = 28;
  std::vector<double> out(line.size(), 0.0);
  for (int i = 1; i + 1 < int(line.size()); ++i) {
    const int above = std::max(0, i - steps(kReach_mm)),
              below = std::min(int(line.size()) - 1, i + steps(kReach_mm));
    out[std::size_t(i)] = outwards(line[std::size_t(i)], line[std::size_t(above)], line[std::size_t(below)]);
  }
  return out;
}

/// The nose tip: from above, the first point that stands out enough and has a hollow above it (the nose's
/// root). Forehead and brow have no such hollow; mouth and chin lie below. nullopt if no point qualifies, or
/// the scan ends above it.
std::optional<int> noseTip(const Outline& line) {
  constexpr double kLength_mm = 60, kLeast_mm = 7, kHollow_mm = 2.5, kNext_mm = 25;
  const std::vector<double> out_mm = prominences(line);
  std::optional<int> best;
  for (int i = steps(kCrown_mm); i + steps(12) < int(line.size()); ++i) {
    if (best && i > *best + steps(kNext_mm)) break;
    const double least_mm = best ? out_mm[std::size_t(*best)] : kLeast_mm;
    if (out_mm[std::size_t(i)] <= least_mm) continue;
    const auto from = out_mm.begin() + std::max(0, i - steps(kLength_mm));
    if (*std::min_element(from, out_mm.begin() + i) < -kHollow_mm) best = i;
  }
  return best;
}

/// True if the head is tilted so far back (some 70 degrees) that its nose lies on the outline's first part,
/// where it is not searched: `tip` is then the chin. An upright head's crown stands out a third as far as its
/// nose.
bool hasNoseAtCrown(const Outline& line, int tip) {
  constexpr double kCrownShare = 0.8;
  const std::vector<double> out_mm = prominences(line);
  const double crown_mm = *std::max_element(out_mm.begin(), out_mm.begin() + steps(kCrown_mm));
  return crown_mm > kCrownShare * out_mm[std::size_t(tip)];
}

/// Base of the nose: the deepest corner between nose and lip below the tip, within the depth of a nose.
std::optional<int> noseBase(const Outline& line, int tip) {
  constexpr double kReach_mm = 12, kLeast_mm = 2;
  std::optional<int> best;
  double deepest_mm = kLeast_mm;
  for (int i = tip + steps(8); i < tip + steps(45) && i + steps(kReach_mm) < int(line.size()); ++i) {
    const auto at = [&](int k) -> const Vector2d& { return line[std::size_t(k)]; };
    const double depth_mm = -outwards(at(i), at(i - steps(kReach_mm)), at(i + steps(kReach_mm)));
    if (depth_mm > deepest_mm) deepest_mm = depth_mm, best = i;
  }
  return best;
}

/// The point of [from, to), above `anchor`, where a line from the anchor touches the outline from outside.
std::optional<int> tangentPoint(const Outline& line, int anchor, int from, int to) {
  std::optional<int> best;
  for (int i = std::max(0, from); i < std::min(to, int(line.size())); ++i) {
    const auto at = [&](int k) -> const Vector2d& { return line[std::size_t(k)]; };
    if (!best || outwards(at(i), at(*best), at(anchor)) > 0) best = i;
  }
  return best;
}

/// The point furthest from `front` on the opposite side of the top of the head. Neck and shoulders lie
/// further away, but not on that side, at any pitch of the head.
std::optional<Vector2d> backOfHead(const MidlineProfile& profile, const Vector2d& front) {
  constexpr double kFirst_rad = 140 * kRadPerDeg, kLast_rad = 198 * kRadPerDeg;
  const auto angle = [&](const Vector2d& p) {
    const Vector2d r = p - profile.centre;
    return std::atan2(r.x(), r.y());  // 0 up, positive to the front
  };
  std::optional<Vector2d> best;
  double longest_mm = 0;
  for (const Vector2d& p : profile.back) {
    const double over_top_rad = angle(front) - angle(p);
    if (over_top_rad < kFirst_rad || over_top_rad > kLast_rad || (p - front).norm() <= longest_mm) continue;
    longest_mm = (p - front).norm();
    best = p;
  }
  return best;
}

/// The point below the back of the head that stands out most from the chord to the nape. nullopt if the scan
/// ends too soon below it.
std::optional<Vector2d> bendToTheNeck(const Outline& back, const Vector2d& opisthocranion) {
  constexpr double kNearest_mm = 12, kFurthest_mm = 62, kNape_mm = 75, kLeastNape_mm = 55, kLeast_mm = 1.0;
  Outline line = back;
  for (Vector2d& p : line) p.x() = -p.x();  // runs down as a face does
  const Vector2d start(-opisthocranion.x(), opisthocranion.y());
  const auto nearer = [&](const Vector2d& a, const Vector2d& b) {
    return (a - start).squaredNorm() < (b - start).squaredNorm();
  };
  const int from = int(std::min_element(line.begin(), line.end(), nearer) - line.begin());
  const int nape = std::min(int(line.size()) - 1, from + steps(kNape_mm));
  if (nape < from + steps(kLeastNape_mm)) return std::nullopt;
  const auto bend = furthest(line, from + steps(kNearest_mm), std::min(nape, from + steps(kFurthest_mm)),
                             line[std::size_t(from)], line[std::size_t(nape)], 1, kLeast_mm);
  return bend ? std::optional(back[std::size_t(*bend)]) : std::nullopt;
}

}  // namespace

MidlineProfile midlineProfile(const std::vector<Vector3d>& head_mm,
                              const std::vector<Eigen::Vector3i>& triangles) {
  const auto points = cutPoints(head_mm, triangles);
  if (points.size() < 50) return {};
  double top_mm = -1e9, front_mm = -1e9, back_mm = 1e9;
  for (const auto& p : points) top_mm = std::max(top_mm, p.y());
  for (const auto& p : points)
    if (p.y() > top_mm - 100) front_mm = std::max(front_mm, p.x()), back_mm = std::min(back_mm, p.x());
  const Vector2d centre(0.5 * (front_mm + back_mm), top_mm - 90);
  return {evenly(outermost(points, centre, 1), kStep_mm), evenly(outermost(points, centre, -1), kStep_mm),
          centre};
}

MidlineLandmarks midlineLandmarks(const MidlineProfile& profile) {
  const Outline& line = profile.front;
  MidlineLandmarks found;
  const std::optional<int> nose_tip = noseTip(line);
  if (nose_tip && hasNoseAtCrown(line, *nose_tip)) return found;
  const int tip = nose_tip.value_or(int(line.size()) - 1);  // the scan may end on the nose's bridge
  if (tip < steps(90)) return found;
  const auto at = [&](int i) { return line[std::size_t(i)]; };
  const auto brow = tangentPoint(line, tip, tip - steps(85), tip - steps(32));
  if (!brow) return found;
  const auto root = furthest(line, *brow, tip, at(*brow), at(tip), -1, nose_tip ? 1.0 : 4.0);
  if (!root) return found;
  if (nose_tip) found.pronasale = at(tip);
  found.nasion = at(*root);
  const int forehead = std::max(0, *root - steps(45));
  if (const auto g = furthest(line, *root - steps(35), *root - steps(5), at(forehead), at(*root), 1, 0.3))
    found.glabella = at(*g);
  if (const auto base = nose_tip ? noseBase(line, tip) : std::nullopt) {
    found.subnasale = at(*base);
    const int low = std::min(int(line.size()) - 1, *base + steps(95));
    if (low > *base + steps(60))
      if (const auto chin = furthest(line, *base + steps(35), low, at(*base), at(low), 1, 2.0))
        found.pogonion = at(*chin);
  }
  found.opisthocranion = backOfHead(profile, found.glabella.value_or(at(*brow)));
  if (found.opisthocranion) found.inion = bendToTheNeck(profile.back, *found.opisthocranion);
  return found;
}

}  // namespace facenav::anatomy
