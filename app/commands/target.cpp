// facenav locate CASE and facenav target CASE: a place of the brain in MRI and MNI coordinates with its
// labels, and a new target at that place, or at the coil's pose in a session.

#include <cstdio>

#include "commands/commands.h"
#include "commands/expert_target.h"
#include "facenav/atlas/brain_template.h"
#include "facenav/casefile/case_store.h"
#include "facenav/core/error.h"
#include "facenav/geometry/rotation.h"
#include "facenav/guidance/handle.h"
#include "facenav/plan/plan_edits.h"

namespace facenav::app {
namespace {

/// Typed place, in one of the two frames.
struct Place {
  std::filesystem::path case_folder;
  std::vector<double> mni_mm, ras_mm;
};

void addPlaceOptions(CLI::App& verb, const std::shared_ptr<Place>& place) {
  verb.add_option("CASE", place->case_folder, "case folder")->required();
  auto* mni = verb.add_option("--mni", place->mni_mm, "x y z in MNI space (mm)")->expected(3);
  auto* ras = verb.add_option("--ras", place->ras_mm, "x y z in the patient's MRI (RAS mm)")->expected(3);
  mni->excludes(ras);
}

Eigen::Vector3d toVector(const std::vector<double>& p) { return {p[0], p[1], p[2]}; }

atlas::AtlasMap atlasOf(const casefile::CaseStore& store) {
  if (const auto map = store.atlas()) return *map;
  throw Error("the case has no atlas registration", store.folder().string(),
              "prepare it again with --replace (its targets are kept), or give --ras");
}

Point<Mri> toMri(const casefile::CaseStore& store, const Place& place) {
  if (!place.mni_mm.empty()) return atlasOf(store).toMri(Point<Mni>(toVector(place.mni_mm)));
  if (!place.ras_mm.empty()) return Point<Mri>(toVector(place.ras_mm));
  throw Error("no place is given", {}, "give --mni X Y Z or --ras X Y Z");
}

void printLabel(const atlas::LabelMap& labels, const Point<Mni>& p) {
  const auto label = atlas::labelAt(labels, p);
  if (label.name.empty()) return void(std::printf("%-9s none within 5 mm\n", labels.name.c_str()));
  std::printf("%-9s %s", labels.name.c_str(), label.name.c_str());
  std::printf(label.distance_mm > 0 ? " (%.0f mm away)\n" : "\n", label.distance_mm);
}

void print(const casefile::CaseStore& store, const Point<Mri>& p) {
  std::printf("RAS       %.1f %.1f %.1f mm\n", p.mm.x(), p.mm.y(), p.mm.z());
  const auto map = store.atlas();
  if (!map) return void(std::printf("MNI       the case has no atlas registration\n"));
  const auto mni = map->toMni(p);
  std::printf("MNI       %.1f %.1f %.1f mm\n", mni.mm.x(), mni.mm.y(), mni.mm.z());
  const auto colin = atlas::readColin27();
  printLabel(colin.aal, mni);
  printLabel(colin.brodmann, mni);
}

}  // namespace

void addLocate(CLI::App& app, Context&) {
  auto* verb = app.add_subcommand(
      "locate", "a place of the brain in MRI and MNI coordinates, with its AAL and Brodmann label");
  auto place = std::make_shared<Place>();
  addPlaceOptions(*verb, place);
  verb->callback([place] {
    const auto store = casefile::CaseStore::open(place->case_folder);
    print(store, toMri(store, *place));
  });
}

void addTarget(CLI::App& app, Context& context) {
  auto* verb = app.add_subcommand("target",
                                  "adds a target to a case, typed in MNI or MRI coordinates; the coil rests "
                                  "on the scalp over it; or where "
                                  "the coil was held in a session");
  struct TargetRequest {
    std::string name;
    double handle_deg = 45, gap_mm = 0;
    bool is_json = false;
    ExpertTargetRequest expert;
  };
  auto place = std::make_shared<Place>();
  auto request = std::make_shared<TargetRequest>();
  addPlaceOptions(*verb, place);
  verb->add_option(
      "--name", request->name,
      "name of the target; one of the same name is replaced; with --from-session: \"expert\" and the "
      "session's target where none is given");
  addExpertOptions(*verb, request->expert);
  verb->add_flag("--json", request->is_json, "with --from-session: JSON");
  verb->add_option("--handle-deg", request->handle_deg, "handle, from anterior towards the midline")
      ->check(CLI::Range(-180.0, 180.0))
      ->capture_default_str();
  verb->add_option("--gap-mm", request->gap_mm, "between coil and scalp (hair)")
      ->check(CLI::Range(0.0, guidance::kMostGap_mm))
      ->capture_default_str();
  verb->callback([&context, place, request] {
    const auto store = casefile::CaseStore::open(place->case_folder);
    if (request->expert.is_wanted)
      return storeExpertTarget(context, store, request->expert, request->name, request->is_json);
    if (request->name.empty()) throw CLI::RequiredError("--name");
    const auto plan = store.targets();
    if (const auto* old = steps::find(plan, request->name); old && old->is_locked)
      throw Error("the target '" + old->name + "' is locked", store.folder().string(), "unlock it first");
    const auto head = steps::plannedHead(store);
    const auto target =
        steps::targetOverCortex(head, request->name, steps::cortexNear(head, toMri(store, *place)),
                                {request->handle_deg * kRadPerDeg, request->gap_mm});
    store.setTargets(steps::with(plan, target.name, target));
    if (context.is_quiet) return;
    print(store, target.cortex_point);
    std::printf("scalp     %.1f mm above it\n", (target.scalp_point.mm - target.cortex_point.mm).norm());
  });
}

}  // namespace facenav::app
