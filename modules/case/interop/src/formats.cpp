#include "facenav/interop/formats.h"

#include <algorithm>

#include "facenav/core/error.h"
#include "facenav/core/near_name.h"
#include "facenav/core/number_text.h"
#include "facenav/core/whole_file.h"
#include "readers.h"
#include "text.h"

namespace facenav::interop {
namespace {

/// Names a kind of file that is known and cannot be read; empty if it is none of them.
std::string knownButNotRead(const std::string& content) {
  if (startsWith(content, "\x89HDF\r\n"))
    return "is an HDF5 file: save a .mat as version 7 or older, a transform as .tfm";
  if (contains(content.substr(0, 520), "MATLAB 7.3 MAT-file"))
    return "is a .mat of version 7.3: save it with '-v7'";
  if (startsWith(content, "\xFF\xFE") || startsWith(content, "\xFE\xFF"))
    return "is text in UTF-16: save it as UTF-8";
  if (startsWith(content, "SQLite format 3"))
    return "is a database, perhaps a Brainsight project: export its targets as text";
  if (startsWith(content, "PK")) return "is an archive: unpack it and choose the file of targets in it";
  if (startsWith(content, "visor2 software version"))
    return "is a visor2 list of pulses, which is not read yet";
  if (contains(content.substr(0, 4000), "nibs_position_id") ||
      contains(content.substr(0, 4000), "nibs_event_id"))
    return "is a file of NIBS-BIDS, which is not read yet";
  if (startsWith(content, "# Version: 1\n") || startsWith(content, "# Version: 1\r"))
    return "is a Brainsight stream of poses without targets or pulses";
  return {};
}

std::vector<Format> makeFormats() {
  return {
      {"brainsight", "Brainsight text export, version 12: targets, pulses, landmarks", "brainsight.txt", true,
       isBrainsight, readBrainsight, writeBrainsight},
      {"localite", "Localite InstrumentMarker; with --session TriggerMarkers", "InstrumentMarker.xml", true,
       isLocalite, readLocalite, writeLocalite},
      {"simnibs-csv", "SimNIBS positions", "simnibs.csv", false, isSimnibsCsv, readSimnibsCsv,
       writeSimnibsCsv},
      {"simnibs-mat", "SimNIBS session for the simulation of all targets", "simnibs.mat", false, isSimnibsMat,
       readSimnibsMat, writeSimnibsMat},
      {"simnibs-py", "SimNIBS script for the simulation of all targets", "simnibs.py", false, nullptr,
       nullptr, writeSimnibsScript},
      {"visor2", "ANT visor2 markers, tied to the T1", "visor2.mrk", false, isVisor2, readVisor2,
       writeVisor2},
      {"softaxic", "SofTaxic", "softaxic.stmpx", false, isSoftaxic, readSoftaxic, writeSoftaxic},
      {"mkss", "InVesalius markers, version 5", "invesalius.mkss", false, isInvesalius, readInvesalius,
       writeInvesalius},
      {"mrk.json", "3D Slicer markups", "slicer.mrk.json", false, isSlicerMarkups, readSlicerMarkups,
       writeSlicerMarkups},
      {"tfm", "transform of one target for 3D Slicer and ITK", "target.tfm", false, isItkTransform,
       readItkTransform, writeItkTransform},
      {"fcsv", "older markups of 3D Slicer", "", false, isFcsv, readFcsv, nullptr},
      {"navinibs", "NaviNIBS targets; with --session samples", "navinibs_targets.json", true, isNavinibs,
       readNavinibs, writeNavinibs},
      {"stimguide", "StimGuide: places", "", false, isStimguide, readStimguide, nullptr},
      {"csv", "targets and pulses as a table", "targets.csv", true, isOwnCsv, readOwnCsv, writeOwnCsv},
      {"json", "targets as in targets.json", "targets.json", false, isOwnJson, readOwnJson, writeOwnJson}};
}

void nameItems(OtherFile& file) {
  int number = 0;
  for (auto& item : file.items) {
    ++number;
    item.name = trimmed(item.name);
    if (item.where.empty()) item.where = formatted("item %d", number);
    if (item.name.empty()) item.name = toString(item.kind) + " " + std::to_string(number);
  }
}

}  // namespace

std::string toString(Kind kind) {
  constexpr const char* kWords[] = {"target", "pulse", "landmark", "electrode"};
  return kWords[int(kind)];
}

std::string toString(Space space) {
  constexpr const char* kWords[] = {"RAS", "LPS", "MNI", "Talairach", "another template", "unknown"};
  return kWords[int(space)];
}

const std::vector<Format>& formats() {
  static const auto kFormats = makeFormats();
  return kFormats;
}

std::string namesOfWritten() {
  std::string names;
  for (const auto& format : formats())
    if (format.write) names += (names.empty() ? "" : ", ") + format.name;
  return names;
}

const Format& writtenFormat(const std::string& name) {
  for (const auto& format : formats())
    if (format.name == name && format.write) return format;
  throw Error("no such format: " + name, {}, "one of " + namesOfWritten());
}

bool isKnown(const std::string& content) {
  if (startsWith(content, "\xEF\xBB\xBF")) return isKnown(content.substr(3));
  if (!knownButNotRead(content).empty() && !startsWith(content, "PK")) return true;
  return std::any_of(formats().begin(), formats().end(),
                     [&](const Format& format) { return format.recognises && format.recognises(content); });
}

OtherFile readOther(const std::filesystem::path& path, const T1* t1) {
  if (!std::filesystem::exists(path)) throw Error("file does not exist", path.string(), "check the path");
  if (!std::filesystem::is_regular_file(path))
    throw Error("is no file", path.string(), "choose one file in it");
  if (std::filesystem::file_size(path) > kLargestFile_bytes)
    throw Error("is larger than 64 MB, which no list of targets is", path.string());
  return readOtherText({readWholeFile(path), path, t1});
}

OtherFile readOtherText(Source source) {
  if (startsWith(source.content, "\xEF\xBB\xBF")) source.content.erase(0, 3);
  const std::string file = source.path.string();
  if (trimmed(source.content).empty()) throw Error("is empty", file, "export it again");
  if (const auto why = knownButNotRead(source.content); !why.empty()) throw Error(why, file);
  for (const auto& format : formats()) {
    if (!format.recognises || !format.recognises(source.content)) continue;
    OtherFile read = format.read(source);
    read.format = format.name;
    if (read.items.size() > kMostItems) throw Error("holds more than 100000 items", file);
    if (read.items.empty()) throw Error("holds no targets, pulses or landmarks (" + read.words + ")", file);
    nameItems(read);
    return read;
  }
  throw Error("is no file of a navigator that FaceNav knows", file,
              "the manual's page on other programs lists them");
}

std::vector<const Item*> posed(const Order& order, Kind kind) {
  std::vector<const Item*> found;
  for (const auto& item : order.items)
    if (item.kind == kind && item.mri_T_coil) found.push_back(&item);
  return found;
}

std::vector<const Item*> targetsOf(const Order& order) {
  auto targets = posed(order, Kind::target);
  if (targets.empty()) throw Error("there is no target to export", {}, "plan one first");
  return targets;
}

void notePulsesLeft(const Order& order, Written& written, const std::string& format) {
  const auto is_pulse = [](const Item& item) { return item.kind == Kind::pulse; };
  const auto count = std::count_if(order.items.begin(), order.items.end(), is_pulse);
  if (count > 0)
    written.notes.push_back(formatted("%d pulses are left out: ", int(count)) + format +
                            " holds targets only");
}

}  // namespace facenav::interop
