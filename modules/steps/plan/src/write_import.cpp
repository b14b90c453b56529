// Writes what the previews of other programs' files say: targets into the plan, pulses as sessions.

#include <chrono>

#include "facenav/core/error.h"
#include "facenav/core/utc_time.h"
#include "facenav/plan/import_other.h"
#include "facenav/plan/plan_edits.h"
#include "facenav/plan/pose_target.h"
#include "imported_session.h"

namespace facenav::steps {
namespace {

using interop::Item;
using interop::Kind;

std::string originOf(const OtherImport& order, const interop::OtherFile& file) {
  return nameOf(order) + " (" + file.words + ")";
}

/// The surfaces that a target's points lie on.
struct Surfaces {
  surface::ScalpSurface scalp;
  std::optional<surface::BrainModel> brain;
};

guidance::Target targetOf(const Surfaces& surfaces, const Item& item, const OtherImport& order,
                          const interop::OtherFile& file) {
  guidance::Target target;
  target.name = item.name;
  target.mri_T_target = item.mri_T_coil->reframe<Mri, frames::Target>();
  target.cortex_point =
      item.cortex_point_mm
          ? Point<Mri>(*item.cortex_point_mm)
          : steps::cortexOnAxis(surfaces.brain ? &*surfaces.brain : nullptr, *item.mri_T_coil);
  target.scalp_point =
      item.scalp_point_mm ? Point<Mri>(*item.scalp_point_mm) : skinOnAxis(surfaces.scalp, *item.mri_T_coil);
  target.note = "from " + originOf(order, file);
  target.changes = {
      {isoUtc(std::chrono::system_clock::now()), order.by, "imported from " + originOf(order, file)}};
  return target;
}

guidance::TreatmentPlan planWith(const casefile::CaseStore& store, const std::vector<PreviewedFile>& files,
                                 int& count) {
  auto plan = store.targets();
  std::optional<Surfaces> surfaces;
  for (const auto& file : files)
    for (const auto& [item, fate, reason] : file.preview.items) {
      if (item.kind != Kind::target || (fate != ItemFate::added && fate != ItemFate::replaced)) continue;
      if (!surfaces) surfaces = Surfaces{store.scalp(), store.brain()};
      const auto target = targetOf(*surfaces, item, file.order, file.preview.file);
      guidance::requireSound(target);
      plan = with(std::move(plan), item.name, target);
      ++count;
    }
  return plan;
}

/// Writes the sessions of all files, hidden until they are committed.
std::vector<NewSession> sessionsOf(const casefile::CaseStore& store, const std::vector<PreviewedFile>& files,
                                   const guidance::TreatmentPlan& plan) {
  std::vector<NewSession> all;
  for (const auto& file : files)
    for (auto& session : newSessions(store, file.order, file.preview, plan, all))
      all.push_back(std::move(session));
  return all;
}

}  // namespace

ImportedItems importOther(const casefile::CaseStore& store, const OtherImport& order,
                          const ImportPreview& preview) {
  return importOthers(store, {{order, preview, {}}},
                      [&](const guidance::TreatmentPlan& plan) { store.setTargets(plan); });
}

ImportedItems importOthers(const casefile::CaseStore& store, const std::vector<PreviewedFile>& files,
                           const WritePlan& write) {
  for (const auto& [order, preview, failure] : files)
    if (!order.skips_refused && preview.count(ItemFate::refused) > 0)
      throw Error(preview.refusal(), order.file.string(), "nothing was imported");
  ImportedItems imported;
  const auto plan = planWith(store, files, imported.targets);
  auto sessions = sessionsOf(store, files, plan);
  try {
    for (auto& session : sessions) {
      session.whole->commit();
      imported.sessions.push_back(session.folder);
      imported.pulses += session.pulses;
    }
    if (imported.targets > 0) write(plan);
  } catch (...) {
    for (const auto& folder : imported.sessions) std::filesystem::remove_all(folder);
    throw;
  }
  return imported;
}

}  // namespace facenav::steps
