#include "facenav/plan/export_other.h"

#include <algorithm>
#include <cctype>
#include <chrono>

#include "facenav/casefile/case_coil.h"
#include "facenav/casefile/kept_session.h"
#include "facenav/casefile/landmarks_file.h"
#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/core/software_version.h"
#include "facenav/core/standard_output.h"
#include "facenav/core/utc_time.h"
#include "facenav/core/whole_file.h"
#include "facenav/core/whole_folder.h"
#include "facenav/plan/plan_edits.h"

namespace facenav::steps {
namespace fs = std::filesystem;
namespace {

using interop::Item;
using interop::Kind;

Item itemOf(const guidance::Target& target) {
  Item item;
  item.name = target.name;
  item.mri_T_coil = target.mri_T_target.reframe<Mri, Coil>();
  item.cortex_point_mm = target.cortex_point.mm;
  item.scalp_point_mm = target.scalp_point.mm;
  return item;
}

Item itemOf(const casefile::ReviewedPulse& reviewed, const std::string& session) {
  const auto& pulse = reviewed.pulse;
  Item item;
  item.kind = Kind::pulse;
  item.name = formatted("Sample %d", pulse.number);
  item.session = session;
  item.target = pulse.target ? pulse.target->name : "";
  item.mri_T_coil = pulse.mri_T_coil();
  if (!item.mri_T_coil) item.reason = pulse.reason;
  item.clock_s = secondsOfUtc(pulse.utc);
  item.onset_s = pulse.t_s;
  item.intensity_pct = pulse.intensity_pct;
  item.mep_uv = pulse.mep_uv;
  item.values["status"] = toString(pulse.status);
  if (pulse.target) item.cortex_point_mm = pulse.target->cortex_point.mm;
  if (reviewed.is_excluded) item.values["Comment"] = "excluded: " + reviewed.note;
  return item;
}

void addTargets(const casefile::CaseStore& store, const OtherExport& order, std::vector<Item>& items) {
  const auto plan = store.targets();
  if (order.targets.empty())
    for (const auto& target : plan.targets) items.push_back(itemOf(target));
  for (const auto& name : order.targets) items.push_back(itemOf(plan.find(name)));
}

void addPulses(const casefile::CaseStore& store, const OtherExport& order, std::vector<Item>& items) {
  std::vector<fs::path> folders;
  if (order.session.empty())
    folders = casefile::sessionFolders(store.folder());
  else
    folders = {casefile::findSession(store.folder(), order.session)};
  for (const auto& folder : folders)
    for (const auto& pulse : casefile::readSessionPulses(folder).pulses)
      items.push_back(itemOf(pulse, folder.filename().string()));
}

void addLandmarks(const casefile::CaseStore& store, std::vector<Item>& items) {
  const auto landmarks = casefile::readLandmarks(store.folder());
  if (!landmarks) return;
  for (const auto which : surface::kLandmarks) {
    const auto& landmark = (*landmarks)[which];
    if (!landmark) continue;
    Item item;
    item.kind = Kind::landmark;
    item.name = toString(which);
    item.mri_place = landmark->point;
    items.push_back(item);
  }
}

std::vector<Item> itemsOf(const casefile::CaseStore& store, const OtherExport& order,
                          const interop::Format& format) {
  std::vector<Item> items;
  addTargets(store, order, items);
  const bool is_whole =
      (order.targets.empty() || order.has_all_sessions) && format.holds_pulses && !holdsOneKind(format.name);
  if (!order.session.empty() || is_whole) addPulses(store, order, items);
  addLandmarks(store, items);
  return items;
}

fs::path placeOf(const OtherExport& order, const interop::Format& format) {
  if (isStandardOutput(order.output)) return order.output;
  if (order.output.empty()) return format.file_name;
  if (format.write_folder) return order.output;
  return fs::is_directory(order.output) ? order.output / format.file_name : order.output;
}

bool isLabel(const std::string& text) {
  return !text.empty() &&
         std::all_of(text.begin(), text.end(), [](unsigned char c) { return c < 128 && std::isalnum(c); });
}

std::string lettersAndDigits(const std::string& text) {
  std::string label;
  for (const unsigned char c : text)
    if (c < 128 && std::isalnum(c)) label += char(c);
  return label;
}

/// Existing::replace for a data set that FaceNav exported. Throws Error for another folder with files in it.
Existing existingAt(const fs::path& folder, bool replaces) {
  std::error_code unknown;
  if (!fs::exists(folder) || fs::is_empty(folder, unknown)) return Existing::refuse;
  if (!replaces) throw Error("the folder is not empty", folder.string(), "choose another one, or --replace");
  const fs::path description = folder / "dataset_description.json";
  const std::string text = fs::is_regular_file(description) ? readWholeFile(description) : std::string();
  if (text.find("\"FaceNav\"") == std::string::npos)
    throw Error("the folder holds something else than a data set of FaceNav", folder.string(),
                "choose another one");
  return Existing::replace;
}

void writeFolder(const interop::WrittenFolder& written, const interop::T1& t1, const fs::path& folder,
                 bool replaces) {
  WholeFolder whole(folder, FileAccess::owner_only, existingAt(folder, replaces));
  const auto at = [&](const std::string& name) {
    const fs::path path = whole.temporaryPath() / name;
    fs::create_directories(path.parent_path());
    return path;
  };
  for (const auto& [name, content] : written.files) writeWholeFile(at(name), content, FileAccess::owner_only);
  fs::copy_file(t1.path, at(written.t1_name));
  whole.commit();
}

}  // namespace

bool holdsOneKind(const std::string& format) { return format == "localite" || format == "navinibs"; }

std::string subjectOf(const casefile::CaseStore& store) {
  const std::string label = store.label(), safe = lettersAndDigits(label);
  const bool has_digit = std::any_of(safe.begin(), safe.end(), [](char c) { return c >= '0' && c <= '9'; });
  const bool is_code = has_digit && label.find(' ') == std::string::npos && safe.size() <= 20;
  return is_code ? safe : lettersAndDigits(store.caseId()).substr(0, 8);
}

ExportedFile exportOther(const casefile::CaseStore& store, const OtherExport& order) {
  const auto& format = interop::writtenFormat(order.format);
  if (!store.hasMri())
    throw Error("the case has no MRI, to which other programs' coordinates refer", store.folder().string());
  ExportedFile exported;
  exported.path = placeOf(order, format);
  const std::string subject = order.subject.empty() ? subjectOf(store) : order.subject;
  if (!isLabel(subject))
    throw Error("a subject's label has letters and digits only, not '" + subject.substr(0, 40) + "'", {},
                "choose one with --subject");
  if (format.write_folder && isStandardOutput(exported.path))
    throw Error(format.name + " is a folder, not one file for standard output", {}, "name a folder with -o");
  if (!format.write_folder && !isStandardOutput(exported.path) && fs::exists(exported.path) &&
      !order.replaces)
    throw Error("the file exists already", exported.path.string(), "choose another name, or --replace");
  interop::Order content;
  content.items = itemsOf(store, order, format);
  content.t1 = interop::readT1(store.folder() / "mri.nii.gz");
  content.coil = casefile::coilOf(store.folder()).name;
  content.software = "FaceNav " + softwareVersion();
  content.utc = isoUtc(std::chrono::system_clock::now());
  content.subject = subject;
  if (format.write_folder) {
    const auto written = format.write_folder(content);
    writeFolder(written, content.t1, exported.path, order.replaces);
    exported.notes = written.notes;
  } else {
    auto written = format.write(content);
    writeWholeFile(exported.path, written.content, FileAccess::owner_only);
    exported.notes = std::move(written.notes);
  }
  for (const auto& item : content.items) {
    exported.targets += item.kind == Kind::target;
    exported.pulses += item.kind == Kind::pulse && format.holds_pulses;
  }
  if (holdsOneKind(format.name) && exported.pulses > 0) exported.targets = 0;
  return exported;
}

}  // namespace facenav::steps
