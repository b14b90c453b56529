#include "facenav/guidance/coil_gap.h"

#include <algorithm>
#include <cmath>

#include "facenav/core/number_text.h"
#include "facenav/core/settings_in_force.h"

namespace facenav::guidance {
namespace {

constexpr double kSurely = 2.0;  // standard errors

}  // namespace

double fieldLost_pct(double gap_mm) {
  const double kept = 1.0 - settingsOf<FieldByGap>().lost_a_mm_pct / 100.0;
  return 100.0 * (1.0 - std::pow(kept, std::max(0.0, gap_mm)));
}

std::optional<double> CoilGap::byStereo_mm() const {
  if (!by_poses_mm || !live) return std::nullopt;
  return *by_poses_mm - live->above_skin_mm;
}

double CoilGap::apartSigma_mm() const { return live ? std::hypot(live->sigma_mm, alignment_sigma_mm) : 0.0; }

bool CoilGap::disagrees() const { return live && std::abs(live->above_skin_mm) > kSurely * apartSigma_mm(); }

std::string disagreementInWords(const CoilGap& gap) {
  if (!gap.disagrees()) return {};
  const double above_mm = gap.live->above_skin_mm;
  return formatted("beside the coil the cameras see the surface %.1f mm %s the MRI's skin (error %.1f): ",
                   std::abs(above_mm), above_mm > 0 ? "outside" : "inside", gap.apartSigma_mm()) +
         (above_mm > 0 ? "hair, or the alignment is off"
                       : "the alignment is off, or something presses the skin");
}

}  // namespace facenav::guidance
