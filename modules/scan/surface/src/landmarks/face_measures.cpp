#include "facenav/surface/face_measures.h"

#include <cmath>

#include "facenav/anatomy/face_norms.h"

namespace facenav::surface {
namespace {

std::optional<UsualRange> rangeOf(const std::optional<anatomy::Norm>& norm) {
  if (!norm) return std::nullopt;
  return UsualRange{norm->low, norm->high};
}

}  // namespace

bool FaceMeasure::isUsual() const {
  if (!usual) return true;
  const bool is_long_enough = is_lower_bound || value_mm + uncertainty_mm >= usual->low_mm;
  return is_long_enough && value_mm - uncertainty_mm <= usual->high_mm;
}

std::vector<FaceMeasure> measureFace(const FaceLandmarks& landmarks, double voxel_mm) {
  constexpr double kTwoSided95 = 1.96;
  const double skin_sd_mm = voxel_mm / std::sqrt(12.0);  // standard deviation of the skin itself, upper bound
  std::vector<FaceMeasure> measures;
  for (const anatomy::FaceNorm& d : anatomy::faceNorms()) {
    const auto a = landmarks.find(d.from), b = landmarks.find(d.to);
    if (!a || !b) continue;
    const double sd_mm = std::sqrt(a->sd_mm * a->sd_mm + b->sd_mm * b->sd_mm + 2 * skin_sd_mm * skin_sd_mm);
    measures.push_back({d.name, d.from, d.to, (a->point.mm - b->point.mm).norm(), kTwoSided95 * sd_mm,
                        rangeOf(d.adults), a->is_cut || b->is_cut});
  }
  if (landmarks.circumference_mm)
    measures.push_back({"circumference of the head", "glabella", "opisthocranion",
                        *landmarks.circumference_mm,
                        kTwoSided95 * std::sqrt(16 + 4 * skin_sd_mm * skin_sd_mm),
                        rangeOf(anatomy::kHeadCircumference), landmarks.is_circumference_cut});
  return measures;
}

}  // namespace facenav::surface
