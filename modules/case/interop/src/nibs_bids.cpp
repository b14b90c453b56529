#include "nibs_bids.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "nibs_run.h"
#include "readers.h"
#include "text.h"

// NIBS-BIDS (BEP037 v6.3, and the keys of older examples): markers.tsv holds places of coils, events.tsv the
// pulses that refer to them, nibs.tsv their strengths, coordsystem.json the space. The text of the standard
// leaves open whether y points along the handle or away from it, so that is asked.

namespace facenav::interop {
namespace {

std::string lowered(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return c < 128 ? char(std::tolower(c)) : char(c); });
  return text;
}

/// Space of a name of a coordinate system in BIDS.
Space spaceOf(const std::string& name) {
  const std::string word = lowered(name);
  for (const char* own : {"individualmri", "individual", "scanras", "scannerras", "native", "t1w", "ras"})
    if (word == own) return Space::ras;
  for (const char* own : {"lps", "scanlps", "dicom"})
    if (word == own) return Space::lps;
  if (contains(word, "talairach")) return Space::talairach;
  for (const char* of_template : {"mni", "icbm", "fsaverage", "fslr", "nihpd", "oasis", "uncinfant", "pnc"})
    if (startsWith(word, of_template))
      return contains(word, "mni") || contains(word, "icbm") ? Space::mni : Space::other_template;
  return Space::unknown;
}

/// An event: one row of events.tsv for one element.
struct Event {
  std::size_t row = 0, element = 0;
  std::string position, kind;  // ids; blank: n/a
};

std::vector<Event> eventsOf(const NibsTable& table) {
  std::vector<Event> events;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::string kind = table.text(row, "nibs_event_id");
    if (kind.empty()) continue;  // another event of the experiment
    const auto positions = partsOf(table.text(row, "nibs_position_id"));
    for (std::size_t i = 0; i < positions.size(); ++i) {
      const std::string position = trimmed(positions[i]) == "n/a" ? "" : trimmed(positions[i]);
      events.push_back({row, i, position, kind});
    }
  }
  return events;
}

/// Columns of a rotation, mm; x may be missing, since it is y x z. Nothing if the row has no rotation.
std::optional<Eigen::Matrix4d> poseOf(const NibsTable& table, std::size_t row,
                                      const Eigen::Vector3d& centre_mm) {
  auto x = table.three(row, "element_xdir_");
  const auto y = table.three(row, "element_ydir_"), z = table.three(row, "element_zdir_");
  if (!y && !z) return std::nullopt;
  const Eigen::Vector3d none = Eigen::Vector3d::Constant(std::nan(""));
  if (!x && y && z) x = y->cross(*z);
  return poseOfColumns(centre_mm, x.value_or(none), y.value_or(none), z.value_or(none));
}

Item placementOf(const NibsTable& table, std::size_t row, double mm_per_unit) {
  Item item;
  item.where = table.where(row);
  item.name = table.text(row, "position_label");
  if (item.name.empty()) item.name = table.text(row, "nibs_position_id");
  for (const char* column : {"nibs_element_id", "position_description", "position_group", "element_distance"})
    if (const std::string cell = table.text(row, column); !cell.empty()) item.values[column] = cell;
  if (const auto p = table.three(row, "target_")) item.cortex_point_mm = mm_per_unit * *p;
  const auto centre = table.three(row, "element_centre_");
  if (centre) item.pose = poseOf(table, row, mm_per_unit * *centre);
  if (item.pose) return item;
  item.kind = Kind::landmark;
  item.reason = centre ? "the file gives no directions of the coil for it"
                       : "the file gives no centre of the coil for it";
  if (centre) item.place_mm = mm_per_unit * *centre;
  if (!centre) item.place_mm = item.cortex_point_mm;
  item.cortex_point_mm.reset();
  return item;
}

/// Adds the targets and pulses of one run to the file.
class RunReader {
 public:
  RunReader(const NibsRun& run, OtherFile& file) : run_(run), file_(file), markers_(run.files, run.markers) {
    for (std::size_t row = 0; row < markers_.rows(); ++row) {
      const std::string id = markers_.text(row, "nibs_position_id");
      if (!rows_.emplace(id, row).second)
        refuseFile(run.files.path(run.markers), formatted("line %d", markers_.line(row)),
                   "has the position '" + id + "' a second time", "give each row an id of its own");
    }
    const std::string name = run.name.beside("events.tsv");
    if (!run.files.has(name)) return;
    events_.emplace(run.files, name);
    list_ = eventsOf(*events_);
    for (const auto& event : list_) {
      ++uses_[event.position];
      const auto duration_s = events_->number(event.row, "duration");
      if (duration_s && *duration_s > 0) ++uses_[event.position];  // a train: the coil was held there
    }
  }
  void addTargets() {
    for (std::size_t row = 0; row < markers_.rows(); ++row) {
      if (isOfOnePulse(row)) continue;
      Item item = placementOf(markers_, row, run_.mm_per_unit);
      if (isOfGroup(row, "pulse")) {  // of no event: a pulse of unknown time
        item.kind = Kind::pulse;
        item.target = item.name;
        item.name = "pulse at " + markers_.text(row, "nibs_position_id");
        item.session = run_.name.words();
        item.place_mm.reset();
      }
      file_.items.push_back(item);
    }
  }
  void addPulses() {
    if (!events_) return;
    const NibsStrengths strengths(run_);
    const auto start_s = startOf(run_);
    int number = 0, trains = 0;
    for (const auto& event : list_) {
      Item item = pulseOf(event, ++number);
      strengths.describe(event.kind, event.element, item);
      if (start_s && item.onset_s) {
        item.clock_s = *start_s + *item.onset_s;
        item.time = dateOf(*item.clock_s) + " " + timeOf(*item.clock_s);
      }
      trains += events_->number(event.row, "duration").value_or(0) > 0;
      file_.items.push_back(item);
    }
    if (trains > 0)
      file_.notes.push_back(formatted("%d pulses stand for a train each, and come in at its start", trains));
  }

 private:
  bool isOfGroup(std::size_t row, const char* group) const {
    return lowered(markers_.text(row, "position_group")) == group;
  }
  /// The row belongs to one pulse, and is no place where a coil was to be held.
  bool isOfOnePulse(std::size_t row) const {
    if (isOfGroup(row, "target")) return false;
    const auto found = uses_.find(markers_.text(row, "nibs_position_id"));
    return found != uses_.end() && (found->second == 1 || isOfGroup(row, "pulse"));
  }
  Item pulseOf(const Event& event, int number) const {
    Item item;
    if (const auto found = rows_.find(event.position); found != rows_.end()) {
      item = placementOf(markers_, found->second, run_.mm_per_unit);
      const std::string of = markers_.text(found->second, "target_label");
      item.target = of.empty() ? item.name : of;
      if (!item.pose) item.reason = "its position '" + event.position + "' is no whole pose";
    } else {
      item.reason = event.position.empty() ? "not tracked: it names no position"
                                           : "its position '" + event.position + "' is not in markers.tsv";
    }
    item.kind = Kind::pulse;
    item.place_mm.reset();
    item.name = formatted("pulse %d", number);
    item.where = events_->where(event.row);
    item.session = run_.name.words();
    item.onset_s = events_->number(event.row, "onset");
    if (item.onset_s && !std::isfinite(*item.onset_s)) item.onset_s.reset();
    if (item.onset_s) item.time = formatted("onset %.3f s", *item.onset_s);
    item.mep_uv = valueIn(events_->text(event.row, "mep_amplitude"));
    for (const char* column : {"pulse_status", "is_excluded"})
      if (const std::string cell = events_->text(event.row, column); !cell.empty())
        item.values[column] = cell;
    return item;
  }

  const NibsRun& run_;
  OtherFile& file_;
  NibsTable markers_;
  std::optional<NibsTable> events_;
  std::vector<Event> list_;
  std::map<std::string, std::size_t> rows_;
  std::map<std::string, int> uses_;
};

/// Name in the set of the T1 that the run is intended for; empty if it names none.
std::string intendedFor(const NibsRun& run) {
  if (!run.coordsystem || !run.coordsystem->has("IntendedFor")) return {};
  std::string name = wordOf(*run.coordsystem, "IntendedFor");
  if (name.empty())
    for (const auto& element : listOf(*run.coordsystem, "IntendedFor"))
      if (name.empty() && element.isText()) name = element.text();
  if (startsWith(name, "bids::")) return name.substr(6);
  const std::string subject = run.name.entity("sub");
  return startsWith(name, "bids:") || subject.empty() ? name : "sub-" + subject + "/" + name;
}

void setSpace(const std::vector<NibsRun>& runs, OtherFile& file) {
  for (const auto& run : runs) {
    const std::string words =
        run.coordsystem ? wordOf(*run.coordsystem, "NIBSCoordinateSystem") : std::string();
    const std::string described =
        run.coordsystem ? wordOf(*run.coordsystem, "NIBSCoordinateSystemDescription") : std::string();
    const std::string image = intendedFor(run);
    const bool is_handle_said = contains(described, kHandleWords);
    if (&run == &runs.front()) {
      file.space_words = words;
      file.space = spaceOf(words);
      file.is_handle_doubtful = !is_handle_said;
      file.image_words = image;
    } else if (words != file.space_words || image != file.image_words ||
               file.is_handle_doubtful == is_handle_said) {
      refuseFile(
          run.files.root(), "",
          "its runs have other coordinate systems: " + runs.front().name.words() + " and " + run.name.words(),
          "choose the markers.tsv of one run");
    }
  }
  const FileSet& files = runs.front().files;
  if (file.image_words.empty()) return;
  if (const auto found = files.onDisk(file.image_words))
    file.intended_t1 = *found;
  else
    file.notes.push_back("it is intended for '" + file.image_words +
                         "', which is not beside it: its world is taken as that of the case's T1");
}

void requireOneSubject(const FileSet& files, const std::vector<std::string>& markers) {
  std::set<std::string> subjects;
  for (const auto& name : markers) subjects.insert("sub-" + NibsName(name).entity("sub"));
  if (subjects.size() < 2) return;
  std::string list;
  for (const auto& subject : subjects) list += (list.empty() ? "" : ", ") + subject;
  refuseFile(files.root(), "", formatted("holds %d people: ", int(subjects.size())) + list.substr(0, 200),
             "choose the folder of one");
}

}  // namespace

std::filesystem::path nibsDataSetOf(const std::filesystem::path& folder) {
  std::error_code unknown;
  for (auto up = folder; up.has_relative_path(); up = up.parent_path())
    if (std::filesystem::exists(up / "dataset_description.json", unknown)) return up;
  return folder;
}

std::vector<std::string> nibsMarkers(const FileSet& files) {
  std::vector<std::string> found;
  for (const auto& name : files.names())
    if (endsWith(name, "_markers.tsv") && !startsWith(name, "derivatives/") &&
        !startsWith(name, "sourcedata/"))
      found.push_back(name);
  return found;
}

OtherFile readNibsSet(const FileSet& files, const std::vector<std::string>& markers) {
  requireOneSubject(files, markers);
  std::vector<NibsRun> runs;
  for (const auto& name : markers) runs.emplace_back(files, name);
  OtherFile file;
  file.words = "NIBS-BIDS";
  file.format = "nibs-bids";
  setSpace(runs, file);
  std::vector<RunReader> readers;
  for (const auto& run : runs) readers.emplace_back(run, file);
  for (auto& reader : readers) reader.addTargets();
  for (auto& reader : readers) reader.addPulses();
  for (const auto& run : runs)
    for (const char* suffix : {"markers.tsv", "events.tsv", "nibs.tsv"})
      if (const auto part = files.onDisk(run.name.beside(suffix))) file.parts.push_back(*part);
  return file;
}

bool isNibsMarkers(const std::string& content) {
  const auto lines = linesOf(content.substr(0, 8000));
  if (lines.empty()) return false;
  const Columns columns(cellsOf(lines[0], '\t'));
  return columns.has("nibs_position_id") && (columns.has("element_centre_x") || columns.has("target_x"));
}

OtherFile readNibsMarkers(const Source& source) {
  std::error_code unknown;
  if (!std::filesystem::is_regular_file(source.path, unknown)) {
    const std::string name = source.path.filename().string();
    return readNibsSet(FileSet({{name, source.content}}, source.path.parent_path()), {name});
  }
  const auto path = std::filesystem::absolute(source.path).lexically_normal();
  const auto root = nibsDataSetOf(path.parent_path());
  const FileSet files = FileSet::below(root, path.parent_path(), false);
  return readNibsSet(files, {path.lexically_relative(root).generic_string()});
}

}  // namespace facenav::interop
