#include "report_targets.h"

#include <cmath>
#include <optional>
#include <vector>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/geometry/rotation.h"
#include "facenav/guidance/handle.h"
#include "report_html.h"

namespace facenav::report {
namespace {

struct UsedTarget {
  guidance::Target target;
  int pulses = 0;
};

/// Lists the targets, one entry per name and pose, in the order of their first pulse: a moved target gets a
/// new entry.
std::vector<UsedTarget> usedTargets(const casefile::KeptSession& session) {
  std::vector<UsedTarget> used;
  for (const auto& [pulse, is_excluded, note] : session.pulses.pulses) {
    if (is_excluded || !pulse.target) continue;
    bool is_known = false;
    for (auto& other : used)
      if (other.target.name == pulse.target->name &&
          other.target.mri_T_target.isometry().isApprox(pulse.target->mri_T_target.isometry(), 1e-6)) {
        ++other.pulses;
        is_known = true;
      }
    if (!is_known) used.push_back({*pulse.target, 1});
  }
  return used;
}

std::string pointWords(const Eigen::Vector3d& p_mm) {
  return formatted("%.1f %.1f %.1f", p_mm.x(), p_mm.y(), p_mm.z());
}

/// Value of `read`, or "not known" if the case lacks what it needs.
template <class Read>
std::string known(Read read) {
  try {
    return read();
  } catch (const Error&) {
    return "not known";
  }
}

}  // namespace

std::string targetsPart(const casefile::CaseStore& store, const casefile::KeptSession& session) {
  const auto used = usedTargets(session);
  if (used.empty()) return headingHtml("Target") + paragraphHtml("No pulse was given at a target.");
  std::optional<surface::ScalpSurface> scalp;
  std::optional<atlas::AtlasMap> atlas;
  known([&] {
    scalp = store.scalp();
    atlas = store.atlas();
    return std::string();
  });
  std::vector<TableRow> rows;
  for (const UsedTarget& one : used) {
    const guidance::Target& target = one.target;
    rows.push_back(
        {keptCell(target.name), pointWords(target.cortex_point.mm),
         atlas ? known([&] { return pointWords(atlas->toMni(target.cortex_point).mm); }) : "not known",
         pointWords(target.mri_T_target.translation_mm()),
         scalp ? known([&] {
           const auto angle = guidance::handleAngle(target, *scalp);
           return formatted("%.0f from %s", angle.angle_rad * kDegPerRad,
                            angle.reference == guidance::HandleReference::anterior ? "anterior" : "superior");
         })
               : "not known",
         formatted("%.1f", guidance::centreGap_mm(target)), formatted("%d", one.pulses)});
  }
  return headingHtml("Target") +
         tableHtml({"name", "on the cortex, MRI (RAS mm)", "MNI (mm)", "coil's centre, MRI (RAS mm)",
                    "handle (deg)", "planned gap (mm)", "pulses"},
                   rows);
}

}  // namespace facenav::report
