// facenav plan CASE: targets from presets, grids, copies, mirror images; landmarks and measures of the head;
// the protocol. Without an option it lists the targets. One option is one step; all use steps::PlanEditor,
// as the window does.

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <set>

#include "commands/coil_option.h"
#include "commands/commands.h"
#include "commands/overlay_steps.h"
#include "commands/plan_print.h"
#include "facenav/casefile/case_coil.h"
#include "facenav/casefile/case_store.h"
#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/geometry/rotation.h"
#include "facenav/guidance/handle.h"
#include "facenav/pictures/plan_picture.h"
#include "facenav/pictures/titled_row.h"
#include "facenav/plan/case_landmarks.h"
#include "facenav/plan/coil_slice_sheet.h"
#include "facenav/plan/overlays.h"
#include "facenav/plan/plan_editor.h"
#include "facenav/prepare/case_pictures.h"
#include "facenav/scene/png.h"
#include "facenav/volume/map_peak.h"
#include "facenav/volume/nifti.h"
#include "idle_options.h"
#include "typed_values.h"
#include "wrong_usage.h"

namespace facenav::app {
namespace {

struct PlanRequest {
  std::filesystem::path case_folder, coil_library, protocol, protocol_template, picture, slices, map;
  bool is_json = false, lists_presets = false, lists_landmarks = false, measures = false,
       shows_protocol = false;
  std::vector<std::string> set_landmarks, find_landmarks, compare;
  std::string coil, preset, name, by = "", target, note, grid_on = "scalp";
  std::optional<volume::MapSpace> map_space;
  std::vector<int> grid;
  std::vector<double> within;
  OverlayRequest overlays;
  double handle_deg = 45, gap_mm = 0, spacing_mm = 7.5, radius_mm = 15;
  bool duplicates = false, mirrors = false, locks = false, unlocks = false, removes = false, has_note = false,
       removes_grid = false, wants_lowest = false;
};

/// Reads "nasion=1.5,85,-40".
std::pair<surface::Landmark, Point<Mri>> readLandmark(const std::string& text) {
  const auto equals = std::min(text.find('='), text.size());
  const auto p = numbersIn(text.substr(std::min(equals + 1, text.size())));
  if (p.size() != 3)
    throw WrongUsage("'" + text + "' is no place of a landmark", "write it as nasion=X,Y,Z (RAS mm)");
  return {surface::landmarkFrom(text.substr(0, equals)), Point<Mri>(p[0], p[1], p[2])};
}

std::string userName() {
  const char* name = std::getenv("USER");
  return name ? name : "";
}

class PlanSteps {
 public:
  PlanSteps(const PlanRequest& request, bool is_quiet)
      : request_(request), is_quiet_(is_quiet), store_(casefile::CaseStore::open(request.case_folder)) {}

  void run() {
    if (!request_.coil.empty())
      casefile::setCoil(
          store_.folder(),
          coil_library::coilFileOf(request_.coil, coil_library::coilLibrary(request_.coil_library)));
    bool has_done = landmarkSteps();
    has_done |= protocolSteps();
    has_done |= targetSteps();
    has_done |= overlaySteps(request_.overlays, store_, request_.is_json, is_quiet_);
    if (request_.measures) printMeasures(headMeasures(), request_.is_json), has_done = true;
    if (request_.compare.size() == 2) compare(), has_done = true;
    if (!request_.picture.empty()) draw(), has_done = true;
    if (!request_.slices.empty()) drawSlices(), has_done = true;
    if (!has_done || (!is_quiet_ && has_edited_)) printPlan(shownPlan(), head(), request_.is_json);
  }

 private:
  const steps::PlannedHead& head() {
    if (!head_) {
      head_ = steps::plannedHead(store_);
    }
    return *head_;
  }
  steps::HeadMeasures headMeasures() { return {head().scalp, steps::landmarksOf(store_, *head().scalp)}; }

  /// The targets that were added, where only that was done; else all.
  guidance::TreatmentPlan shownPlan() const {
    auto plan = store_.targets();
    if (added_.empty() || is_other_edited_) return plan;
    const auto isOld = [&](const guidance::Target& target) {
      const bool is_of_grid = target.grid_place && added_.count(target.grid_place->seed) == 1;
      return added_.count(target.name) == 0 && !is_of_grid;
    };
    plan.targets.erase(std::remove_if(plan.targets.begin(), plan.targets.end(), isOld), plan.targets.end());
    return plan;
  }

  bool landmarkSteps() {
    std::vector<std::pair<surface::Landmark, Point<Mri>>> places;
    for (const std::string& text : request_.set_landmarks) places.push_back(readLandmark(text));
    for (const auto& [which, p] : places) steps::setLandmark(store_, *head().scalp, which, p, request_.by);
    for (const std::string& name : request_.find_landmarks)
      steps::findLandmarkAgain(store_, *head().scalp, surface::landmarkFrom(name));
    const bool has_set = !request_.set_landmarks.empty() || !request_.find_landmarks.empty();
    if (request_.lists_landmarks || (has_set && !is_quiet_))
      printLandmarks(steps::landmarksOf(store_, *head().scalp), request_.is_json);
    return has_set || request_.lists_landmarks;
  }

  bool protocolSteps() {
    if (!request_.protocol.empty())
      casefile::setProtocol(store_.folder(), casefile::readProtocol(request_.protocol));
    const bool has_set = !request_.protocol.empty();
    if (request_.shows_protocol || (has_set && !is_quiet_))
      printProtocol(casefile::protocolOf(store_.folder()), request_.is_json);
    return has_set || request_.shows_protocol;
  }

  bool targetSteps() {
    auto planned = steps::plannedCase(store_, request_.by);
    planned.head = [this] { return head(); };
    steps::PlanEditor editor(planned);
    editor.begin();
    if (!request_.preset.empty()) addPreset(editor);
    if (!request_.map.empty()) addPeak(editor);
    if (!request_.target.empty()) editor.setActive(store_.targets().find(request_.target).name);
    const bool has_added = !request_.preset.empty() || !request_.map.empty();
    has_edited_ |= has_added;
    const auto step = [&](bool is_wanted, auto edit) {
      if (!is_wanted) return;
      const bool is_named = !request_.target.empty() || has_added;
      if (!is_named || !editor.active()) throw WrongUsage("no target is named", "give --target NAME");
      edit();
      has_edited_ = true;
    };
    step(request_.unlocks, [&] { editor.setLocked(false); });
    step(request_.has_note, [&] { editor.setNote(request_.note); });
    step(!request_.grid.empty(), [&] { editor.setGrid(gridSpec()); });
    step(request_.removes_grid, [&] { editor.setGrid(std::nullopt); });
    step(request_.locks, [&] { editor.setLocked(true); });
    step(request_.duplicates, [&] { editor.duplicate(), added_.insert(editor.active()->name); });
    step(request_.mirrors, [&] { mirror(editor), added_.insert(editor.active()->name); });
    step(request_.removes, [&] { editor.remove(), is_other_edited_ = true; });
    return has_edited_;
  }

  void addPreset(steps::PlanEditor& editor) {
    const auto& preset = steps::presetNamed(request_.preset);
    const auto map = store_.atlas();
    const auto place = steps::placeOf(preset, map ? &*map : nullptr, headMeasures());
    editor.addTarget(place, request_.name.empty() ? preset.name : request_.name, wish());
    added_.insert(editor.active()->name);
    if (!is_quiet_ && !request_.is_json) std::printf("%s\n", place.words.c_str());
  }

  void addPeak(steps::PlanEditor& editor) {
    const auto wanted = request_.wants_lowest ? volume::PeakOf::lowest : volume::PeakOf::highest;
    const auto& centre = request_.within;
    const auto map = volume::readNifti(request_.map);
    const bool is_mni = volume::spaceOfMap(map, request_.map_space, request_.map) == volume::MapSpace::mni;
    const auto peak =
        volume::peakWithin(map.volume, {centre[0], centre[1], centre[2]}, request_.radius_mm, wanted);
    steps::PresetPlace place;
    place.cortex = Point<Mri>(peak.place_mm);
    if (is_mni) place.cortex = atlas().toMri(Point<Mni>(peak.place_mm));
    const Eigen::Vector3d& p = peak.place_mm;
    place.words = formatted("peak %.2f of %s at %s %.1f %.1f %.1f%s", peak.value,
                            request_.map.filename().c_str(), is_mni ? "MNI" : "RAS", p.x(), p.y(), p.z(),
                            peak.is_at_edge ? ", at the region's rim: the map goes on there" : "");
    editor.addTarget(place, request_.name.empty() ? "map peak" : request_.name, wish());
    added_.insert(editor.active()->name);
    if (!is_quiet_ && !request_.is_json) std::printf("%s\n", place.words.c_str());
  }

  steps::CoilWish wish() const { return {request_.handle_deg * kRadPerDeg, request_.gap_mm}; }

  atlas::AtlasMap atlas() const {
    if (const auto map = store_.atlas()) return *map;
    throw Error("the case has no atlas registration", store_.folder().string(),
                "prepare it again with --replace (its targets are kept)");
  }

  guidance::GridSpec gridSpec() const {
    return {request_.grid[0], request_.grid[1], request_.spacing_mm,
            request_.grid_on == "cortex" ? guidance::GridOn::cortex : guidance::GridOn::scalp};
  }

  void mirror(steps::PlanEditor& editor) {
    const atlas::AtlasMap map = atlas();
    editor.mirror([&](const Point<Mri>& p) {
      Point<Mni> there = map.toMni(p);
      there.mm.x() = -there.mm.x();
      return map.toMri(there);
    });
  }

  void draw() {
    const auto measures = headMeasures();
    std::vector<pictures::NamedPlace> landmarks, sites;
    for (const auto which : surface::kLandmarks)
      if (const auto& landmark = measures.landmarks()[which])
        landmarks.push_back({toString(which), landmark->point});
    if (measures.landmarks().isComplete()) {
      for (const auto& site : measures.eegSites().sites) sites.push_back({site.name, site.point});
      sites.push_back({"Beam F3", measures.beamF3(guidance::Side::left).point});
      sites.push_back({"Beam F4", measures.beamF3(guidance::Side::right).point});
    }
    scene::writePng(pictures::drawPlan(*head().scalp, landmarks, sites, store_.targets().targets,
                                       head().plate, request_.target),
                    request_.picture);
  }

  /// Draws slices along the coil's axis, for the named target or for every one.
  void drawSlices() {
    scene::SliceScene scene;
    scene.mri = std::make_shared<const volume::Volume>(store_.mri());
    scene::setUsualWindow(scene);
    scene.overlays = steps::loadOverlays(store_, scene.mri->grid);
    const auto plan = store_.targets();
    std::vector<RgbImage> rows;
    for (const auto& target : plan.targets)
      if (request_.target.empty() || target.name == plan.find(request_.target).name)
        rows.push_back(
            steps::coilSliceSheet(scene, target, head().plate, steps::alignedBound95_mm(store_, target)));
    if (rows.empty()) throw Error("the case has no target", store_.folder().string(), "add one first");
    for (const auto& entry : casefile::readOverlays(store_.folder()))
      if (entry.is_shown && entry.kind == casefile::OverlayKind::map) rows.push_back(steps::mapScale(entry));
    steps::writePrivatePng(pictures::stacked(rows), request_.slices);
  }

  void compare() {
    const auto plan = store_.targets();
    const auto &a = plan.find(request_.compare[0]), &b = plan.find(request_.compare[1]);
    const double along_mm =
        surface::ScalpPaths(head().scalp->mesh).shortest(a.scalp_point.mm, b.scalp_point.mm).length_mm();
    printDifference(a.name, b.name, guidance::compareTargets(a, b), along_mm, request_.is_json);
  }

  const PlanRequest& request_;
  bool is_quiet_, has_edited_ = false, is_other_edited_ = false;
  std::set<std::string> added_;  // names of new targets
  casefile::CaseStore store_;
  std::optional<steps::PlannedHead> head_;
};

void addTargetOptions(CLI::App& verb, PlanRequest& request) {
  auto* preset = verb.add_option("--preset", request.preset, "adds a target at a preset (see --list-presets)")
                     ->check(understoodBy([](const std::string& name) { steps::presetNamed(name); }));
  auto* map = verb.add_option("--peak", request.map, "adds a target at the peak of a NIfTI map (fMRI)");
  auto* within = verb.add_option("--within", request.within, "x y z of the map's region, mm, in its space");
  within->expected(3)->needs(map);
  map->needs(within)->excludes(preset);
  verb.add_option("--radius-mm", request.radius_mm, "of the region")
      ->check(CLI::Range(1.0, 100.0))
      ->capture_default_str();
  verb.add_flag("--lowest", request.wants_lowest, "the lowest value (maps of anticorrelation)");
  verb.add_option_function<std::string>(
          "--map-space",
          [&request](const std::string& word) {
            request.map_space = word == "mni" ? volume::MapSpace::mni : volume::MapSpace::mri;
          },
          "the map's space: mni, mri; needed where the file does not say that it lies in a template's space")
      ->check(CLI::IsMember({"mni", "mri"}));
  verb.add_option("--name", request.name, "name of the new target; one of the same name is replaced");
  verb.add_option("--handle-deg", request.handle_deg, "handle, from anterior towards the midline")
      ->check(CLI::Range(-180.0, 180.0))
      ->capture_default_str();
  verb.add_option("--gap-mm", request.gap_mm, "between coil and scalp (hair)")
      ->check(CLI::Range(0.0, guidance::kMostGap_mm))
      ->capture_default_str();
  verb.add_option("--coil", request.coil,
                  "coil that the case is planned for from now on: its name in the library, or its coil.json "
                  "(contact_outline_mm: its plate)");
  addCoilLibraryOption(verb, request.coil_library);
  verb.add_option("--target", request.target, "the target that the next options change");
  verb.add_option("--grid", request.grid, "a grid round the target: rows columns")->expected(2);
  verb.add_option("--spacing-mm", request.spacing_mm, "of the grid")
      ->check(CLI::Range(1.0, 30.0))
      ->capture_default_str();
  verb.add_option("--on", request.grid_on, "the grid is measured on: scalp, cortex")
      ->check(CLI::IsMember({"scalp", "cortex"}))
      ->capture_default_str();
  verb.add_flag("--no-grid", request.removes_grid, "removes its grid; edited targets stay")
      ->excludes(verb.get_option("--grid"));
  verb.add_flag("--duplicate", request.duplicates, "a copy of it");
  verb.add_flag("--mirror", request.mirrors, "the same on the other side of the head");
  verb.add_flag("--lock", request.locks, "it cannot be changed");
  verb.add_flag("--unlock", request.unlocks, "it can be changed again")->excludes(verb.get_option("--lock"));
  verb.add_flag("--remove", request.removes, "removes it, and its grid but for edited targets");
  verb.add_option_function<std::string>(
      "--note", [&request](const std::string& note) { request.note = note, request.has_note = true; },
      "its note");
}

void refuseIdleOptions(const CLI::App& verb) {
  refuseIdle(verb, {"--name", "--handle-deg", "--gap-mm"}, {"--preset", "--peak"});
  refuseIdle(verb, {"--lowest", "--radius-mm", "--map-space"}, {"--peak"});
  refuseIdle(verb, {"--spacing-mm", "--on"}, {"--grid"});
  refuseIdle(verb, {"--threshold", "--full", "--opacity", "--unit"}, {"--overlay", "--overlay-name"});
  refuseIdle(verb, {"--target"},
             {"--grid", "--no-grid", "--duplicate", "--mirror", "--lock", "--unlock", "--remove", "--note",
              "--picture", "--slices"});
}

}  // namespace

void addPlan(CLI::App& app, Context& context) {
  auto* verb = app.add_subcommand(
      "plan", "targets of a case: presets, EEG sites, Beam F3, grids; landmarks of the head; the protocol");
  auto request = std::make_shared<PlanRequest>();
  request->by = userName();
  auto* folder = verb->add_option("CASE", request->case_folder, "case folder");
  verb->add_flag("--list-presets", request->lists_presets, "the presets");
  addTargetOptions(*verb, *request);
  verb->add_flag("--landmarks", request->lists_landmarks, "nasion, inion, tragi: place, error, origin");
  verb->add_option("--set-landmark", request->set_landmarks, "sets a landmark by hand: nasion=X,Y,Z (RAS mm)")
      ->check(understoodBy([](const std::string& words) { readLandmark(words); }))
      ->allow_extra_args(false);
  verb->add_option("--find-landmark", request->find_landmarks,
                   "finds a landmark again: nasion, inion, tragus-left, ..")
      ->check(understoodBy([](const std::string& name) { surface::landmarkFrom(name); }))
      ->allow_extra_args(false);
  verb->add_flag("--measures", request->measures, "tape measures, EEG sites, Beam F3 and F4");
  verb->add_option("--picture", request->picture, "PNG of the head with landmarks, EEG sites and coils");
  verb->add_option("--slices", request->slices,
                   "PNG of the MRI along the coil's axis, at --target or at every target");
  verb->add_option("--compare", request->compare, "two targets: how they differ")->expected(2);
  addOverlayOptions(*verb, request->overlays);
  verb->add_option("--protocol", request->protocol, "protocol file that the case uses from now on");
  verb->add_flag("--show-protocol", request->shows_protocol, "the case's protocol");
  verb->add_option("--protocol-template", request->protocol_template,
                   "writes a protocol file to fill in, and nothing else ('-': standard output)");
  verb->add_option("--by", request->by, "who makes the change (default: the user's login name)");
  verb->add_flag("--json", request->is_json, "JSON");
  verb->callback([&context, request, folder, verb] {
    if (request->lists_presets) return printPresets(request->is_json);
    if (!request->protocol_template.empty())
      return casefile::writeProtocolTemplate(request->protocol_template);
    if (folder->empty()) throw CLI::RequiredError("CASE");
    refuseIdleOptions(*verb);
    PlanSteps(*request, context.is_quiet).run();
  });
}

}  // namespace facenav::app
