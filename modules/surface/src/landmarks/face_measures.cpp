#include "facenav/surface/face_measures.h"

#include <cmath>

namespace facenav::surface {
namespace {

struct Definition {
  const char *name, *from, *to;
  double usual_low_mm, usual_high_mm;
};
constexpr Definition kDefinitions[] = {
    {"inner corners of the eyes", "endocanthion R", "endocanthion L", 26, 45},
    {"centres of the closed lids", "lid centre R", "lid centre L", 54, 74},
    {"nose length, root to tip", "nasion", "pronasale", 37, 58},
    {"nose height, root to base", "nasion", "subnasale", 41, 62},
    {"nose depth, base to tip", "subnasale", "pronasale", 14, 26},
    {"nose width over the wings", "alare R", "alare L", 27, 51},
    {"nose tip to inner corner of the right eye", "pronasale", "endocanthion R", 0, 0},
    {"nose tip to inner corner of the left eye", "pronasale", "endocanthion L", 0, 0},
    {"nose root to chin", "nasion", "pogonion", 88, 125},
    {"width of the face", "zygion R", "zygion L", 115, 155},
    {"ear to ear (tragus)", "tragion R", "tragion L", 122, 160},
    {"right tragus to nose root", "tragion R", "nasion", 105, 135},
    {"left tragus to nose root", "tragion L", "nasion", 105, 135},
    {"right tragus to nose tip", "tragion R", "pronasale", 118, 155},
    {"left tragus to nose tip", "tragion L", "pronasale", 118, 155},
    {"width of the head", "euryon R", "euryon L", 134, 168},
    {"length of the head", "glabella", "opisthocranion", 166, 214},
};
constexpr double kCircumferenceLow_mm = 515, kCircumferenceHigh_mm = 615;

}  // namespace

bool FaceMeasure::isUsual() const {
  if (usual_high_mm <= 0) return true;
  const bool is_long_enough = is_lower_bound || value_mm + uncertainty_mm >= usual_low_mm;
  return is_long_enough && value_mm - uncertainty_mm <= usual_high_mm;
}

std::vector<FaceMeasure> measureFace(const FaceLandmarks& landmarks, double voxel_mm) {
  constexpr double kTwoSided95 = 1.96;
  const double skin_sd_mm = voxel_mm / std::sqrt(12.0);  // of the skin itself, at most
  std::vector<FaceMeasure> measures;
  for (const Definition& d : kDefinitions) {
    const auto a = landmarks.find(d.from), b = landmarks.find(d.to);
    if (!a || !b) continue;
    const double sd_mm = std::sqrt(a->sd_mm * a->sd_mm + b->sd_mm * b->sd_mm + 2 * skin_sd_mm * skin_sd_mm);
    measures.push_back({d.name, d.from, d.to, (a->point.mm - b->point.mm).norm(), kTwoSided95 * sd_mm,
                        d.usual_low_mm, d.usual_high_mm, a->is_cut || b->is_cut});
  }
  if (landmarks.circumference_mm > 0)
    measures.push_back({"circumference of the head", "glabella", "opisthocranion", landmarks.circumference_mm,
                        kTwoSided95 * std::sqrt(16 + 4 * skin_sd_mm * skin_sd_mm), kCircumferenceLow_mm,
                        kCircumferenceHigh_mm, landmarks.is_circumference_cut});
  return measures;
}

}  // namespace facenav::surface
