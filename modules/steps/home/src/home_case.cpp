#include "facenav/home/home_case.h"

#include <chrono>
#include <nlohmann/json.hpp>

#include "facenav/align/stored_capture.h"
#include "facenav/casefile/kept_session.h"
#include "facenav/casefile/sha256.h"
#include "facenav/coil_library/coil_library.h"
#include "facenav/core/json_reader.h"
#include "facenav/core/number_text.h"
#include "facenav/core/software_version.h"
#include "facenav/core/standard_output.h"
#include "facenav/core/utc_time.h"
#include "facenav/core/whole_file.h"
#include "facenav/core/whole_folder.h"
#include "facenav/core/zip_file.h"
#include "facenav/measured_face/skin_model.h"
#include "facenav/prepare/sign_off_gate.h"

namespace facenav::steps {
namespace fs = std::filesystem;
namespace {

using HomeJson = nlohmann::ordered_json;

constexpr const char *kManifest = "home.json", *kFormat = "facenav home case";
constexpr int kHomeVersion = 1;

/// Returns the named expert's pose, or the only one.
const guidance::Target& expertTarget(const guidance::TreatmentPlan& plan, const std::string& name,
                                     const fs::path& folder) {
  const guidance::Target* chosen = nullptr;
  std::string names;
  for (const auto& target : plan.targets) {
    if (!target.expert || (!name.empty() && target.name != name)) continue;
    if (chosen)
      throw Error("the case has several expert's poses", folder.string(),
                  "choose one: " + names + ", '" + target.name + "'");
    chosen = &target;
    names = "'" + target.name + "'";
  }
  if (chosen) return *chosen;
  throw Error(name.empty() ? "the case has no expert's pose" : "'" + name + "' is no expert's pose",
              folder.string(), "store one with 'facenav target CASE --from-session'");
}

fs::path coilOfExpert(const casefile::CaseStore& store, const guidance::ExpertPose& expert,
                      const HomeOrder& order) {
  const fs::path of_case = store.folder() / "coil.json";
  if (!order.coil.empty()) return coil_library::coilFileOf(order.coil, order.coil_library);
  if (fs::exists(of_case) && coil_tracking::readCoil(of_case).name == expert.coil) return of_case;
  try {
    return coil_library::findCoil(order.coil_library, expert.coil).file;
  } catch (const Error&) {
    throw Error("the expert's coil '" + expert.coil + "' is not in the library", order.coil_library.string(),
                "give its coil.json with --coil");
  }
}

void requireExpertsCoil(const std::string& coil, const guidance::ExpertPose& expert) {
  if (expert.coil.empty() || coil == expert.coil) return;
  throw Error("the expert held the coil '" + expert.coil + "', this is '" + coil + "'", {},
              "use the expert's coil, or store the pose again with this one");
}

/// Throws Error unless pose and face of a case with an MRI are of one alignment; otherwise their errors would
/// add up.
void requireSameAlignment(const casefile::CaseStore& store, const std::string& session) {
  const auto folder = casefile::findSession(store.folder(), session);
  if (fs::last_write_time(store.folder() / "alignment.json") <= fs::last_write_time(folder / "poses.csv"))
    return;
  throw Error("the case was aligned again since the expert's session " + session, store.folder().string(),
              "export before the next visit, or store the expert's pose of a session of the last alignment");
}

FaceModel measuredAtAlignment(const face::FaceDetector& detector, const casefile::CaseStore& store,
                              TaskMonitor& monitor) {
  const auto alignment = store.alignment();
  const fs::path pictures = store.folder() / "alignment_capture";
  if (!alignment || !fs::exists(pictures))
    throw Error("the case was never aligned, so no face was measured", store.folder().string(),
                "align it with a recording first");
  if (alignment->from.value_or("dots") != "dots") return keptFace(*alignment, store.folder());
  const auto seen = capture::openCapture(pictures);
  if (!seen.capture)
    throw Error("the pictures of the alignment are missing", pictures.string(), "align again");
  const auto scalp =
      registration::keptScalpField(measured_face::skinModel(store.scalp()), store.scalpField());
  FaceModelSetup setup{detector};
  setup.camera_T_mri = alignment->camera_T_mri;
  setup.scalp = scalp.get();
  setup.size_error = alignment->face_size_error;
  return measureFaceModel(seen.rig, *seen.capture, measured_face::AlignedFrom::dots, setup, monitor);
}

/// Removes what may name people: the note and the editors' names.
guidance::Target withoutNames(guidance::Target target) {
  target.note.clear();
  target.changes.clear();
  target.grid.reset();
  target.grid_place.reset();
  target.is_locked = true;
  return target;
}

/// Copies the coil's file with its patterns and mesh, under plain names.
void copyCoil(const fs::path& coil_json, const fs::path& case_folder) {
  const auto model = coil_tracking::readCoil(coil_json);
  HomeJson json = HomeJson::parse(readWholeFile(coil_json));
  json.erase("mesh");
  int number = 0;
  const auto take = [&](HomeJson& marker) {
    if (!marker.contains("pattern")) return;
    const std::string name = formatted("coil_pattern_%d.patt", ++number);
    writeWholeFile(case_folder / name,
                   readWholeFile(coil_json.parent_path() / marker["pattern"].get<std::string>()),
                   FileAccess::owner_only);
    marker["pattern"] = name;
  };
  if (json.contains("marker")) take(json["marker"]);
  if (json.contains("markers"))
    for (auto& marker : json["markers"]) take(marker);
  json["name"] = model.name;
  writeWholeFile(case_folder / "coil.json",
                 json.dump(1, ' ', false, HomeJson::error_handler_t::replace) + "\n", FileAccess::owner_only);
}

std::map<std::string, std::string> filesOf(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file()) files[entry.path().filename().string()] = readWholeFile(entry.path());
  return files;
}

HomeJson manifestOf(const casefile::CaseStore& store, const guidance::Target& target,
                    const std::optional<FaceModel>& face) {
  HomeJson json{{"format", kFormat},
                {"version", kHomeVersion},
                {"case_id", store.caseId()},
                {"made_utc", isoUtc(std::chrono::system_clock::now())},
                {"software_version", softwareVersion()},
                {"relative_to", "the visit at which the face was measured"},
                {"target", target.name}};
  if (face && face->skin.measurement) {
    const auto& measured = *face->skin.measurement;
    json["face"] = {{"from", measured_face::nameOf(face->from)},
                    {"points", measured.points},
                    {"point_sigma_mm", measured.point_mm},
                    {"whole_sigma_mm", measured.whole_mm}};
    if (measured.size) json["face"]["size_sigma"] = *measured.size;
  }
  json["sha256"] = HomeJson::object();
  return json;
}

/// Temporary folder beside the file; removed by the destructor.
struct PassingFolder {
  explicit PassingFolder(const fs::path& beside) : path(beside.string() + ".tmp_home") {
    fs::remove_all(path);
    makePrivateFolder(path);
  }
  ~PassingFolder() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
  fs::path path;
};

HomeJson checkedManifest(const std::map<std::string, std::string>& entries, const fs::path& file) {
  const auto found = entries.find(kManifest);
  if (found == entries.end())
    throw Error("is no home case of FaceNav", file.string(), "choose the file that the clinic gave");
  const JsonReader json = JsonReader::readText(found->second, file);
  if (json.at("format").text() != kFormat) json.at("format").refuse("is no home case of FaceNav");
  if (json.at("version").integer() != kHomeVersion)
    throw Error("the home case is of another version of FaceNav", file.string(), "update FaceNav");
  json.at("sha256").members();
  json.at("case_id").text();
  if (!secondsOfUtc(json.at("made_utc").text())) json.at("made_utc").refuse("is no time");
  return HomeJson::parse(found->second);
}

/// Time when the case in the folder was made at the clinic; empty if its manifest lacks it.
std::string madeUtcOf(const fs::path& case_folder) {
  if (!fs::is_regular_file(case_folder / kManifest)) return {};
  const HomeJson json = HomeJson::parse(readWholeFile(case_folder / kManifest), nullptr, false);
  if (!json.is_object() || !json.contains("made_utc") || !json["made_utc"].is_string()) return {};
  return json["made_utc"].get<std::string>();
}

void requireNoNewerCase(const fs::path& case_folder, const HomeJson& manifest, const fs::path& file) {
  const std::string there = madeUtcOf(case_folder), fresh = manifest["made_utc"].get<std::string>();
  const auto there_s = secondsOfUtc(there);
  if (!there_s || *secondsOfUtc(fresh) >= *there_s) return;
  throw Error("it was made on " + fresh + ", the case that is there already on " + there, file.string(),
              "choose the newest file of the clinic");
}

}  // namespace

HomeExport exportHome(const face::FaceDetector& detector, const casefile::CaseStore& store,
                      const HomeOrder& order, const fs::path& file, TaskMonitor& monitor) {
  requireSignOff(store, false);
  HomeExport made;
  made.target = withoutNames(expertTarget(store.targets(), order.target, store.folder()));
  const fs::path coil_json = coilOfExpert(store, *made.target.expert, order);
  made.coil = coil_tracking::readCoil(coil_json).name;
  requireExpertsCoil(made.coil, *made.target.expert);
  casefile::FaceCase face_case;
  face_case.case_id = store.caseId();
  if (store.hasMri()) {
    requireSameAlignment(store, made.target.expert->session);
    made.face = measuredAtAlignment(detector, store, monitor);
    face_case.face = made.face->skin;
    face_case.findings = {faceFinding(*made.face)};
  } else {
    face_case.face = store.scalp();
    face_case.findings = store.findings();
  }
  const PassingFolder passing(file);
  const auto home = casefile::CaseStore::createFromFace(passing.path / "case", face_case,
                                                        {{"home", softwareVersion(), {}, {}}}, false);
  home.setTargets({{made.target}});
  copyCoil(coil_json, home.folder());
  if (fs::exists(store.folder() / "protocol.json"))
    fs::copy_file(store.folder() / "protocol.json", home.folder() / "protocol.json");
  casefile::signOff(home, {order.released_by, "", true});
  HomeJson manifest = manifestOf(home, made.target, made.face);
  auto entries = filesOf(home.folder());
  for (const auto& [name, ignored] : entries)
    manifest["sha256"][name] = casefile::sha256OfFile(home.folder() / name);
  entries[kManifest] = manifest.dump(1, ' ', false, HomeJson::error_handler_t::replace) + "\n";
  writeZip(entries, file, FileAccess::owner_only);
  made.bytes = isStandardOutput(file) ? 0 : fs::file_size(file);
  return made;
}

bool isHomeFile(const fs::path& file) {
  if (readWholeFile(file).rfind("PK", 0) != 0) return false;
  return readZip(file).count(kManifest) == 1;
}

casefile::CaseStore importHome(const fs::path& file, const fs::path& case_folder) {
  const auto entries = readZip(file);
  const HomeJson manifest = checkedManifest(entries, file);
  const bool exists = fs::exists(case_folder / "case.json");
  const auto before = exists ? std::optional(casefile::CaseStore::openToReplace(case_folder)) : std::nullopt;
  if (before && before->caseId() != manifest["case_id"].get<std::string>())
    throw Error("another case is there already", case_folder.string(), "choose another folder");
  if (before && before->hasMri())
    throw Error("this is the case with the MRI that the file was made of", case_folder.string(),
                "choose another folder");
  if (before) requireNoNewerCase(case_folder, manifest, file);
  WholeFolder fresh(case_folder, FileAccess::owner_only, exists ? Existing::replace : Existing::refuse);
  for (const auto& [name, content] : entries) {
    const fs::path path = fresh.temporaryPath() / name;
    if (fs::path(name).has_parent_path())
      throw Error("holds a folder '" + name + "' that was not expected", file.string());
    writeWholeFile(path, content, FileAccess::owner_only);
    if (name == kManifest) continue;
    const auto stated = manifest["sha256"].find(name);
    if (stated == manifest["sha256"].end() || *stated != casefile::sha256OfFile(path))
      throw Error("'" + name + "' in it has changed since it was made", file.string(),
                  "ask the clinic for the file again");
  }
  for (const auto& [name, ignored] : manifest["sha256"].items())
    if (!entries.count(name))
      throw Error("'" + name + "' is missing in it", file.string(), "ask the clinic for the file again");
  if (exists && fs::exists(case_folder / "sessions"))
    fs::copy(case_folder / "sessions", fresh.temporaryPath() / "sessions", fs::copy_options::recursive);
  fresh.commit();
  return casefile::CaseStore::open(case_folder);
}

HomeCase openHomeCase(const fs::path& case_folder) {
  const auto store = casefile::CaseStore::open(case_folder);
  if (!store.scalp().has_face)
    throw Error("the case holds no face to know the person by", case_folder.string(),
                "ask the clinic for the file again");
  requireSignOff(store, false);
  HomeCase home{store, expertTarget(store.targets(), "", case_folder), {}, {}};
  const fs::path coil = store.folder() / "coil.json";
  if (!fs::exists(coil))
    throw Error("the case names no coil", case_folder.string(), "ask the clinic for the file again");
  home.coil = coil_tracking::readCoil(coil);
  home.card = coil_tracking::readCoilCard(coil);
  requireExpertsCoil(home.coil.name, *home.target.expert);
  return home;
}

}  // namespace facenav::steps
