#include <algorithm>
#include <cmath>
#include <set>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "json_pose.h"
#include "nibs_bids.h"
#include "readers.h"
#include "text.h"

// Writes a case as a data set of NIBS-BIDS (BEP037 v6.3): one person, one run a session. Neither names nor
// dates are written: times are seconds since a session's first pulse.

namespace facenav::interop {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kCoil = "Coil_1";
constexpr const char* kStimulator = "Stim_1";
constexpr const char* kTask = "tms";

constexpr const char* kFrameWords =
    "World of the T1 named in IntendedFor: RAS mm. element_centre is the middle of the coil's contact face; "
    "the directions are the columns of SimNIBS's matsimnibs: z points into the head, ";

/// A cell: one line without tabs, "n/a" if blank.
std::string cell(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = ' ';
  text = trimmed(text);
  return text.empty() ? "n/a" : text;
}

std::string numberCell(const std::optional<double>& value, const char* format) {
  return value ? formatted(format, *value + 0.0) : "n/a";
}

std::string line(const std::vector<std::string>& cells) {
  std::string text;
  for (const auto& one : cells) text += (text.empty() ? "" : "\t") + one;
  return text + "\n";
}

/// A column's name, meaning and unit.
struct Column {
  std::string name, meaning, unit;
};

std::string header(const std::vector<Column>& columns) {
  std::vector<std::string> names;
  for (const auto& column : columns) names.push_back(column.name);
  return line(names);
}

void describe(const std::vector<Column>& columns, Json& json) {
  for (const auto& [name, meaning, unit] : columns) {
    json[name]["Description"] = meaning;
    if (unit == "number")
      json[name]["Format"] = unit;
    else if (!unit.empty())
      json[name]["Units"] = unit;
  }
}

std::vector<Column> markerColumns() {
  std::vector<Column> columns{
      {"nibs_position_id", "place of a coil; events.tsv refers to it", ""},
      {"nibs_element_id", "the coil, as in ElementSet of nibs.json", ""},
      {"position_label", "name of the planned target; of a pulse, its target", ""},
      {"position_group", "target: a planned place; pulse: where the coil was at one pulse", ""}};
  for (const char axis : {'x', 'y', 'z'})
    columns.push_back({std::string("element_centre_") + axis, "middle of the coil's contact face", "mm"});
  for (const char of : {'x', 'y', 'z'})
    for (const char axis : {'x', 'y', 'z'})
      columns.push_back({formatted("element_%cdir_%c", of, axis),
                         of == 'z'   ? "direction into the head"
                         : of == 'y' ? "direction away from the handle: the handle points the other way"
                                     : "y x z",
                         "number"});
  for (const char axis : {'x', 'y', 'z'})
    columns.push_back({std::string("target_") + axis, "point on the cortex that is aimed at", "mm"});
  columns.push_back({"target_label", "name of the target", ""});
  return columns;
}

std::string markerRow(const std::string& id, const Item& item, bool is_pulse) {
  const Eigen::Matrix4d m = item.mri_T_coil->matrix();
  const std::string name = cell(is_pulse ? item.target : item.name);
  std::vector<std::string> cells{id, kCoil, name, is_pulse ? "pulse" : "target"};
  for (int axis = 0; axis < 3; ++axis) cells.push_back(plainFixed(m(axis, 3), 6));
  for (int of = 0; of < 3; ++of)
    for (int axis = 0; axis < 3; ++axis) cells.push_back(plainFixed(m(axis, of), 9));
  for (int axis = 0; axis < 3; ++axis)
    cells.push_back(item.cortex_point_mm ? plainFixed((*item.cortex_point_mm)[axis], 6) : "n/a");
  cells.push_back(name);
  return line(cells);
}

std::vector<Column> eventColumns() {
  return {{"onset", "time of the pulse since the first one of the session", "s"},
          {"duration", "0: a single pulse", "s"},
          {"nibs_event_id", "row of nibs.tsv", ""},
          {"nibs_position_id", "row of markers.tsv; n/a: head or coil was not seen", ""},
          {"mep_amplitude", "peak-to-peak of the motor evoked potential", "uV"},
          {"pulse_status", "on_target, outside (of the tolerance) or lost (no pose)", ""},
          {"is_excluded", "yes: excluded when the session was reviewed", ""}};
}

std::vector<Column> stimulusColumns() {
  return {{"nibs_event_id", "kind of pulse", ""},
          {"nibs_type", "TMS: transcranial magnetic stimulation", ""},
          {"stimulator_id", "as in StimulatorSet", ""},
          {"nibs_element_id", "as in ElementSet", ""},
          {"stimulus_shape", "n/a: not known to the navigation", ""},
          {"stimulus_intensity", "strength that the stimulator was set to", "% Maximum Stimulator Output"},
          {"stimulus_count", "pulses of one event", "number"}};
}

/// Id of a strength's row in nibs.tsv.
std::string kindOf(const std::optional<double>& intensity_pct) {
  return intensity_pct ? formatted("tms-%g", *intensity_pct) : "tms";
}

/// The tables of one session.
struct Tables {
  std::string markers = header(markerColumns()), events = header(eventColumns()),
              stimuli = header(stimulusColumns());
  int without_time = 0;
};

std::string valueOf(const Item& item, const char* key) {
  const auto found = item.values.find(key);
  return found == item.values.end() ? std::string() : found->second;
}

Tables tablesOf(const std::vector<const Item*>& targets, const std::vector<const Item*>& pulses) {
  Tables tables;
  int number = 0;
  for (const auto* target : targets)
    tables.markers += markerRow(formatted("target-%d", ++number), *target, false);
  const bool has_clock =
      std::any_of(pulses.begin(), pulses.end(), [](const Item* p) { return p->clock_s.has_value(); });
  const auto secondsOf = [&](const Item& pulse) { return has_clock ? pulse.clock_s : pulse.onset_s; };
  std::optional<double> first_s;
  for (const auto* pulse : pulses)
    if (const auto time_s = secondsOf(*pulse); time_s && (!first_s || *time_s < *first_s)) first_s = time_s;
  std::set<std::string> kinds;
  number = 0;
  for (const auto* pulse : pulses) {
    const std::string of_pulse = formatted("pulse-%d", ++number), id = pulse->mri_T_coil ? of_pulse : "n/a";
    if (pulse->mri_T_coil) tables.markers += markerRow(id, *pulse, true);
    const std::string kind = kindOf(pulse->intensity_pct);
    std::optional<double> onset_s = secondsOf(*pulse);
    if (onset_s) *onset_s -= *first_s;
    tables.without_time += !onset_s;
    tables.events +=
        line({numberCell(onset_s, "%.3f"), "0", kind, id, numberCell(pulse->mep_uv, "%.9g"),
              cell(valueOf(*pulse, "status")), valueOf(*pulse, "Comment").empty() ? "no" : "yes"});
    if (kinds.insert(kind).second)
      tables.stimuli +=
          line({kind, "TMS", kStimulator, kCoil, "n/a", numberCell(pulse->intensity_pct, "%g"), "1"});
  }
  return tables;
}

/// Landmarks under their short names in BIDS.
Json landmarksOf(const Order& order, bool as_voxels) {
  const std::map<std::string, std::string> kShort{
      {"nasion", "NAS"}, {"inion", "INI"}, {"tragus-left", "LT"}, {"tragus-right", "RT"}};
  Json json = Json::object();
  for (const auto& item : order.items) {
    if (item.kind != Kind::landmark || !item.mri_place) continue;
    const auto found = kShort.find(item.name);
    const Eigen::Vector3d p =
        as_voxels ? Eigen::Vector3d(order.t1.grid.mri_from_voxel.inverse() * item.mri_place->mm)
                  : item.mri_place->mm;
    json[found == kShort.end() ? item.name : found->second] = {
        std::round(p.x() * 1e4) / 1e4, std::round(p.y() * 1e4) / 1e4, std::round(p.z() * 1e4) / 1e4};
  }
  return json;
}

Json coordsystemOf(const Order& order, const std::string& t1_name) {
  return {{"NIBSCoordinateSystem", "IndividualMRI"},
          {"NIBSCoordinateUnits", "mm"},
          {"NIBSCoordinateSystemDescription", std::string(kFrameWords) + kHandleWords + ", x = y x z."},
          {"IntendedFor", "bids::" + t1_name},
          {"AnatomicalLandmarkCoordinates", landmarksOf(order, false)},
          {"AnatomicalLandmarkCoordinateSystem", "IndividualMRI"},
          {"AnatomicalLandmarkCoordinateUnits", "mm"},
          {"AnatomicalLandmarkCoordinateSystemDescription",
           "NAS nasion, INI inion, LT and RT left and right tragus (not the preauricular points)"},
          {"NavigationSystem",
           {{"Navigation", true},
            {"NavigationHardwareType", "optical_tracking"},
            {"NavigationModelName", "FaceNav"},
            {"NavigationSoftwareVersion", order.software}}}};
}

Json stimulusJson(const Order& order) {
  Json json{
      {"NIBSDescription", "single pulses of transcranial magnetic stimulation, navigated by FaceNav"},
      {"StimulatorSet",
       Json::array(
           {{{"StimulatorID", kStimulator}, {"Manufacturer", "n/a"}, {"ManufacturersModelName", "n/a"}}})},
      {"ElementSet",
       Json::array({{{"ElementID", kCoil}, {"ElementType", "coil"}, {"ModelName", cell(order.coil)}}})}};
  describe(stimulusColumns(), json);
  return json;
}

/// The files around the sessions.
void addFrame(const Order& order, const std::string& subject, WrittenFolder& written) {
  auto& files = written.files;
  files[".bidsignore"] = "**/nibs/\n";
  files["dataset_description.json"] =
      jsonText({{"Name", "Transcranial magnetic stimulation navigated by FaceNav"},
                {"BIDSVersion", "1.10.0"},
                {"DatasetType", "raw"},
                {"GeneratedBy", Json::array({{{"Name", "FaceNav"}, {"Version", order.software}}})}});
  files["participants.tsv"] = "participant_id\n" + subject + "\n";
  files["participants.json"] = jsonText({{"participant_id", {{"Description", "label of the person"}}}});
  files["README"] =
      "One person's targets and pulses of transcranial magnetic stimulation, exported by FaceNav.\n\n"
      "The T1 in anat/ is not defaced: it shows the person's face. Share it only as the consent allows.\n"
      "There are no names, dates of birth or dates of sessions in these files; times are seconds since the\n"
      "first pulse of a session, and each run is one session.\n\n"
      "The folder nibs/ follows the draft NIBS-BIDS (BEP037 v6.3), which BIDS has not adopted yet; the file\n"
      ".bidsignore therefore hides it from the validator. In its tables y points away from the coil's "
      "handle,\n"
      "and z into the head. Each column is described in the .json of the same name.\n";
  files[subject + "/anat/" + subject + "_T1w.json"] =
      jsonText({{"Modality", "MR"}, {"AnatomicalLandmarkCoordinates", landmarksOf(order, true)}});
}

void addRun(const Order& order, const std::string& beginning, const Tables& tables, WrittenFolder& written) {
  auto& files = written.files;
  Json markers = Json::object(), events = Json::object();
  describe(markerColumns(), markers);
  describe(eventColumns(), events);
  files[beginning + "markers.tsv"] = tables.markers;
  files[beginning + "markers.json"] = jsonText(markers);
  files[beginning + "events.tsv"] = tables.events;
  files[beginning + "events.json"] = jsonText(events);
  files[beginning + "nibs.tsv"] = tables.stimuli;
  files[beginning + "nibs.json"] = jsonText(stimulusJson(order));
  files[beginning + "coordsystem.json"] = jsonText(coordsystemOf(order, written.t1_name));
  if (tables.without_time > 0)
    written.notes.push_back(formatted("%d pulses have no time: their onset is n/a", tables.without_time));
}

}  // namespace

WrittenFolder writeNibsBids(const Order& order) {
  const std::string subject = "sub-" + order.subject;
  WrittenFolder written;
  written.t1_name = subject + "/anat/" + subject + "_T1w.nii.gz";
  const auto targets = posed(order, Kind::target);
  std::vector<std::string> sessions;
  std::map<std::string, std::vector<const Item*>> pulses;
  for (const auto& item : order.items) {
    if (item.kind != Kind::pulse) continue;
    if (pulses.count(item.session) == 0) sessions.push_back(item.session);
    pulses[item.session].push_back(&item);
  }
  if (targets.empty() && pulses.empty())
    throw Error("there is no target and no pulse to export", {}, "plan one first");
  addFrame(order, subject, written);
  const std::string beginning = subject + "/nibs/" + subject + "_task-" + kTask + "_";
  if (sessions.empty()) addRun(order, beginning, tablesOf(targets, {}), written);
  for (std::size_t i = 0; i < sessions.size(); ++i)
    addRun(order, beginning + formatted("run-%02d_", int(i) + 1), tablesOf(targets, pulses[sessions[i]]),
           written);
  written.notes.push_back("the T1 shows the person's face: README says so");
  return written;
}

}  // namespace facenav::interop
