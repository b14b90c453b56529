// facenav locate CASE and facenav target CASE: a place of the brain in MRI and MNI coordinates with its
// labels, and a new target at that place, or at the coil's pose in a session.

#include <algorithm>
#include <cstdio>

#include "commands/commands.h"
#include "commands/expert_target.h"
#include "facenav/atlas/brain_template.h"
#include "facenav/casefile/case_store.h"
#include "facenav/core/error.h"
#include "facenav/geometry/json_transform.h"
#include "facenav/geometry/rotation.h"
#include "facenav/guidance/handle.h"
#include "facenav/plan/plan_edits.h"
#include "facenav/surface/outside_head.h"
#include "json_output.h"
#include "wrong_usage.h"

namespace facenav::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kFarthestPlace_mm = 1000;  // beyond it no number is a place in a head

/// Typed place, in one of the two frames.
struct Place {
  std::filesystem::path case_folder;
  std::vector<double> mni_mm, ras_mm;
};

void addPlaceOptions(CLI::App& verb, const std::shared_ptr<Place>& place) {
  verb.add_option("CASE", place->case_folder, "case folder")->required();
  auto* mni = verb.add_option("--mni", place->mni_mm, "x y z in MNI space (mm)")
                  ->expected(3)
                  ->check(CLI::Range(-kFarthestPlace_mm, kFarthestPlace_mm));
  auto* ras = verb.add_option("--ras", place->ras_mm, "x y z in the patient's MRI (RAS mm)")
                  ->expected(3)
                  ->check(CLI::Range(-kFarthestPlace_mm, kFarthestPlace_mm));
  mni->excludes(ras);
}

void requirePlace(const Place& place) {
  if (place.mni_mm.empty() && place.ras_mm.empty())
    throw WrongUsage("no place is given", "give --mni X Y Z or --ras X Y Z");
}

Eigen::Vector3d toVector(const std::vector<double>& p) { return {p[0], p[1], p[2]}; }

atlas::AtlasMap atlasOf(const casefile::CaseStore& store) {
  if (const auto map = store.atlas()) return *map;
  throw Error("the case has no atlas registration", store.folder().string(),
              "prepare it again with --replace (its targets are kept), or give --ras");
}

Point<Mri> toMri(const casefile::CaseStore& store, const Place& place) {
  if (!place.mni_mm.empty()) return atlasOf(store).toMri(Point<Mni>(toVector(place.mni_mm)));
  return Point<Mri>(toVector(place.ras_mm));
}

void printLabel(const atlas::LabelMap& labels, const Point<Mni>& p) {
  const auto label = atlas::labelAt(labels, p);
  if (label.name.empty()) return void(std::printf("%-9s none within 5 mm\n", labels.name.c_str()));
  std::printf("%-9s %s", labels.name.c_str(), label.name.c_str());
  std::printf(label.distance_mm > 0 ? " (%.0f mm away)\n" : "\n", label.distance_mm);
}

Json labelJson(const atlas::LabelMap& labels, const Point<Mni>& p) {
  const auto label = atlas::labelAt(labels, p);
  if (label.name.empty()) return nullptr;
  return {{"name", label.name}, {"distance_mm", label.distance_mm}};
}

Json placeJson(const casefile::CaseStore& store, const Point<Mri>& p) {
  Json json{{"ras_mm", tenths(p.mm)}, {"mni_mm", nullptr}};
  const auto map = store.atlas();
  if (!map) return json;
  const auto mni = map->toMni(p);
  const auto colin = atlas::readColin27();
  json["mni_mm"] = tenths(mni.mm);
  for (const auto* labels : {&colin.aal, &colin.brodmann}) json[labels->name] = labelJson(*labels, mni);
  return json;
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

/// The new target alone.
void printTarget(const casefile::CaseStore& store, const guidance::Target& target, bool is_json) {
  const double above_mm = (target.scalp_point.mm - target.cortex_point.mm).norm();
  if (is_json) {
    Json json{{"name", target.name}, {"mri_T_target", rowMajor(target.mri_T_target)}};
    json["scalp_above_mm"] = tenth(above_mm);
    json.update(placeJson(store, target.cortex_point));
    return printJson(json);
  }
  std::printf("target    %s\n", target.name.c_str());
  print(store, target.cortex_point);
  std::printf("scalp     %.1f mm above it\n", above_mm);
}

}  // namespace

void addLocate(CLI::App& app, Context&) {
  auto* verb = app.add_subcommand(
      "locate", "a place of the brain in MRI and MNI coordinates, with its AAL and Brodmann label");
  auto place = std::make_shared<Place>();
  auto is_json = std::make_shared<bool>(false);
  addPlaceOptions(*verb, place);
  verb->add_flag("--json", *is_json, "as JSON");
  verb->callback([place, is_json] {
    requirePlace(*place);
    const auto store = casefile::CaseStore::open(place->case_folder);
    const auto p = toMri(store, *place);
    const double outside_mm =
        store.hasMri() ? surface::outsideHead_mm(store.headMask(), store.scalp(), p) : 0.0;
    if (*is_json) {
      Json json = placeJson(store, p);
      json["outside_head_mm"] = tenth(std::max(0.0, outside_mm));
      return printJson(json);
    }
    print(store, p);
    if (outside_mm > 0) std::printf("outside   %.0f mm outside the head\n", outside_mm);
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
  for (const char* place_of : {"--mni", "--ras"})
    verb->get_option("--from-session")->excludes(verb->get_option(place_of));
  verb->add_flag("--json", request->is_json, "as JSON");
  verb->add_option("--handle-deg", request->handle_deg, "handle, from anterior towards the midline")
      ->check(CLI::Range(-180.0, 180.0))
      ->capture_default_str();
  verb->add_option("--gap-mm", request->gap_mm, "between coil and scalp (hair)")
      ->check(CLI::Range(0.0, guidance::kMostGap_mm))
      ->capture_default_str();
  verb->callback([&context, place, request] {
    if (!request->expert.is_wanted) requirePlace(*place);
    if (!request->expert.is_wanted && request->name.empty()) throw CLI::RequiredError("--name");
    const auto store = casefile::CaseStore::open(place->case_folder);
    if (request->expert.is_wanted)
      return storeExpertTarget(context, store, request->expert, request->name, request->is_json);
    const auto plan = store.targets();
    if (const auto* old = steps::find(plan, request->name); old && old->is_locked)
      throw Error("the target '" + old->name + "' is locked", store.folder().string(), "unlock it first");
    const auto head = steps::plannedHead(store);
    const auto target =
        steps::targetOverCortex(head, request->name, steps::cortexNear(head, toMri(store, *place)),
                                {request->handle_deg * kRadPerDeg, request->gap_mm});
    store.setTargets(steps::with(plan, target.name, target));
    if (request->is_json || !context.is_quiet) printTarget(store, target, request->is_json);
  });
}

}  // namespace facenav::app
