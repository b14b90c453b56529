#include "facenav/guidance/eeg_sites.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>

#include "facenav/core/error.h"

namespace facenav::guidance {
namespace {

using Eigen::Vector3d;
using surface::Landmark;
using surface::ScalpLandmarks;
using surface::ScalpPath;
using surface::ScalpPaths;

class SitePlacer {
 public:
  SitePlacer(const ScalpPaths& scalp, const ScalpLandmarks& landmarks)
      : scalp_(scalp),
        nasion_(landmarks.known(Landmark::nasion).point.mm),
        inion_(landmarks.known(Landmark::inion).point.mm),
        left_(landmarks.known(Landmark::tragus_left).point.mm),
        right_(landmarks.known(Landmark::tragus_right).point.mm) {}

  EegSites place() {
    findVertex();
    const ScalpPath midline = scalp_.tape(nasion_, vertex_, inion_);
    const ScalpPath across = scalp_.tape(left_, vertex_, right_);
    add("Cz", vertex_);
    divide(midline, {{"Fpz", 0.1}, {"Fz", 0.3}, {"Pz", 0.7}, {"Oz", 0.9}});
    divide(across, {{"T7", 0.1}, {"C3", 0.3}, {"C4", 0.7}, {"T8", 0.9}});
    const ScalpPath left = scalp_.tape(at("Fpz"), at("T7"), at("Oz"));
    const ScalpPath right = scalp_.tape(at("Fpz"), at("T8"), at("Oz"));
    divide(left, {{"Fp1", 0.1}, {"F7", 0.3}, {"P7", 0.7}, {"O1", 0.9}});
    divide(right, {{"Fp2", 0.1}, {"F8", 0.3}, {"P8", 0.7}, {"O2", 0.9}});
    between("F7", "Fz", "F8", "F3", "F4");
    between("P7", "Pz", "P8", "P3", "P4");
    EegSites result;
    for (const std::string& name : eegSiteNames()) result.sites.push_back(placed_.at(name));
    result.nasion_inion_mm = midline.length_mm();
    result.tragus_tragus_mm = across.length_mm();
    result.circumference_mm = left.length_mm() + right.length_mm();
    return result;
  }

 private:
  /// Sets Cz to the middle of both tapes that pass through it.
  void findVertex() {
    constexpr int kMostRounds = 40;
    constexpr double kAboveAll_mm = 200, kStill_mm = 0.01;
    const Vector3d centre = 0.25 * (nasion_ + inion_ + left_ + right_);
    const Vector3d up = (right_ - left_).cross(nasion_ - inion_).normalized();
    vertex_ = scalp_.onSkin(centre + kAboveAll_mm * up).point.mm;
    for (int round = 0; round < kMostRounds; ++round) {
      const Vector3d before = vertex_;
      vertex_ = scalp_.tape(nasion_, vertex_, inion_).atFraction(0.5);
      vertex_ = scalp_.tape(left_, vertex_, right_).atFraction(0.5);
      if ((vertex_ - before).norm() < kStill_mm) return;
    }
  }

  void add(const std::string& name, const Vector3d& on_tape_mm) {
    const auto skin = scalp_.onSkin(on_tape_mm);
    placed_[name] = {name, skin.point, skin.distance_mm, 0.0};
  }
  void divide(const ScalpPath& tape, const std::vector<std::pair<std::string, double>>& parts) {
    for (const auto& [name, fraction] : parts) add(name, tape.atFraction(fraction));
  }
  const Vector3d& at(const std::string& name) const { return placed_.at(name).point.mm; }

  /// Places the points halfway between the middle and either end, along the tape `left` - `middle` - `right`.
  void between(const std::string& left, const std::string& middle, const std::string& right,
               const std::string& left_half, const std::string& right_half) {
    const ScalpPath tape = scalp_.tape(at(left), at(middle), at(right));
    double middle_mm = 0, nearest_mm = 1e300;
    constexpr double kStep_mm = 0.25;
    for (double s = 0; s <= tape.length_mm(); s += kStep_mm)
      if (const double away = (tape.at(s) - at(middle)).norm(); away < nearest_mm)
        nearest_mm = away, middle_mm = s;
    add(left_half, tape.at(0.5 * middle_mm));
    add(right_half, tape.at(0.5 * (middle_mm + tape.length_mm())));
  }

  const ScalpPaths& scalp_;
  Vector3d nasion_, inion_, left_, right_, vertex_ = Vector3d::Zero();
  std::map<std::string, EegSite> placed_;
};

std::string lower(std::string text) {
  for (char& c : text) c = char(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

/// Returns two directions along the skin at a point.
std::array<Vector3d, 2> alongSkin(const ScalpPaths& scalp, const Vector3d& p_mm) {
  const Vector3d out = scalp.onSkin(p_mm).normal.v;
  const Vector3d up = std::abs(out.z()) < 0.9 ? Vector3d::UnitZ() : Vector3d::UnitY();
  const Vector3d a = (up - up.dot(out) * out).normalized();
  return {a, out.cross(a)};
}

}  // namespace

const std::vector<std::string>& eegSiteNames() {
  static const std::vector<std::string> kNames{"Fpz", "Fp1", "Fp2", "F7", "F3", "Fz", "F4",
                                               "F8",  "T7",  "C3",  "Cz", "C4", "T8", "P7",
                                               "P3",  "Pz",  "P4",  "P8", "O1", "O2", "Oz"};
  return kNames;
}

const EegSite& EegSites::find(const std::string& name) const {
  static const std::map<std::string, std::string> kOldNames{
      {"t3", "t7"}, {"t4", "t8"}, {"t5", "p7"}, {"t6", "p8"}};
  const auto old = kOldNames.find(lower(name));
  const std::string wanted = old == kOldNames.end() ? lower(name) : old->second;
  std::string known;
  for (const EegSite& site : sites) {
    if (lower(site.name) == wanted) return site;
    known += (known.empty() ? "" : ", ") + site.name;
  }
  throw Error("there is no EEG site '" + name + "'", {}, "choose one of: " + known);
}

EegSites placeEegSites(const ScalpPaths& scalp, const ScalpLandmarks& landmarks) {
  return SitePlacer(scalp, landmarks).place();
}

EegSites placeEegSitesWithErrors(const ScalpPaths& scalp, const ScalpLandmarks& landmarks) {
  EegSites sites = placeEegSites(scalp, landmarks);
  std::vector<double> squares(sites.sites.size(), 0.0);
  for (const Landmark which : surface::kLandmarks)
    for (const Vector3d& along : alongSkin(scalp, landmarks.known(which).point.mm)) {
      ScalpLandmarks moved = landmarks;
      auto& landmark = *moved[which];
      landmark.point = scalp.onSkin(landmark.point.mm + landmark.sd_mm * along).point;
      const EegSites there = placeEegSites(scalp, moved);
      for (std::size_t i = 0; i < squares.size(); ++i)
        squares[i] += (there.sites[i].point.mm - sites.sites[i].point.mm).squaredNorm();
    }
  for (std::size_t i = 0; i < squares.size(); ++i) sites.sites[i].sd_mm = std::sqrt(squares[i]);
  return sites;
}

}  // namespace facenav::guidance
