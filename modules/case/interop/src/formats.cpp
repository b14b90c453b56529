#include "facenav/interop/formats.h"

#include <algorithm>
#include <map>
#include <regex>

#include "facenav/core/error.h"
#include "facenav/core/near_name.h"
#include "facenav/core/number_text.h"
#include "facenav/core/whole_file.h"
#include "file_set.h"
#include "folders.h"
#include "readers.h"
#include "text.h"

namespace facenav::interop {
namespace {

constexpr double kSamePose = 1e-6;  // in mm and in the rotation: one pose that stands in two lists

/// True for UTF-16, with its mark or without: every other byte of Latin text is 0 then.
bool isUtf16(const std::string& content) {
  if (startsWith(content, "\xFF\xFE") || startsWith(content, "\xFE\xFF")) return true;
  constexpr std::size_t kLooked = 32;
  if (content.size() < kLooked) return false;
  int zeros[2] = {0, 0};
  for (std::size_t i = 0; i < kLooked; ++i) zeros[i % 2] += content[i] == '\0';
  const int all = int(kLooked) / 2;
  return (zeros[0] == all && zeros[1] == 0) || (zeros[1] == all && zeros[0] == 0);
}

/// Names a kind of file that is known and cannot be read; empty if it is none of them.
std::string knownButNotRead(const std::string& content) {
  if (startsWith(content, "\x89HDF\r\n"))
    return "is an HDF5 file: save a .mat as version 7 or older, a transform as .tfm";
  if (contains(content.substr(0, 520), "MATLAB 7.3 MAT-file"))
    return "is a .mat of version 7.3: save it with '-v7'";
  if (isUtf16(content)) return "is text in UTF-16: save it as UTF-8";
  if (startsWith(content, "SQLite format 3"))
    return "is a database, perhaps a Brainsight project: export its targets as text";
  if (startsWith(content, "PK"))
    return "is an archive without a session: unpack it and choose the file in it";
  if (startsWith(content, "onset\t") || startsWith(content, "nibs_event_id\t"))
    return "is a table of events, perhaps of NIBS-BIDS: choose the folder or its markers.tsv";
  if (startsWith(content, "# Version: 1\n") || startsWith(content, "# Version: 1\r"))
    return "is a Brainsight stream of poses without targets or pulses";
  return {};
}

/// A table as a spreadsheet saved it, in the form that the readers of tables know; nothing for other text.
std::optional<std::string> savedBySpreadsheet(const std::string& content) {
  auto table = withCommas(content);
  return table && (isSimnibsCsv(*table) || isOwnCsv(*table)) ? table : std::nullopt;
}

std::vector<Format> makeFormats() {
  return {
      {"brainsight", "Brainsight text export, version 12: targets, pulses, landmarks", "brainsight.txt", true,
       isBrainsight, readBrainsight, writeBrainsight},
      {"localite", "Localite InstrumentMarker; with --session TriggerMarkers", "InstrumentMarker.xml", true,
       isLocalite, readLocalite, writeLocalite},
      {"simnibs-csv", "coil positions of SimNIBS", "simnibs.csv", false, isSimnibsCsv, readSimnibsCsv,
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
      {"stimguide", "StimGuide: places and pulses", "", false, isStimguide, readStimguide, nullptr},
      {"visor2-pulses", "ANT visor2's list of pulses", "", false, isVisor2Pulses, readVisor2Pulses, nullptr},
      {"nibs-bids", "a folder of NIBS-BIDS: targets, pulses, T1", "nibs-bids", true, isNibsMarkers,
       readNibsMarkers, nullptr, writeNibsBids},
      {"csv", "targets and pulses as a table", "targets.csv", true, isOwnCsv, readOwnCsv, writeOwnCsv},
      {"json", "targets as in targets.json", "targets.json", false, isOwnJson, readOwnJson, writeOwnJson}};
}

/// Line breaks and tabs of a name become blanks.
std::string onOneLine(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return c < 0x20 || c == 0x7F; }, ' ');
  return trimmed(name);
}

void nameItems(OtherFile& file) {
  int number = 0;
  for (auto& item : file.items) {
    ++number;
    item.name = onOneLine(item.name);
    item.target = onOneLine(item.target);
    item.session = onOneLine(item.session);
    if (item.where.empty()) item.where = formatted("item %d", number);
    if (item.name.empty()) item.name = toString(item.kind) + " " + std::to_string(number);
  }
}

/// True if poses are no numbers and the text has commas between digits where its cells end with tabs.
bool holdsDecimalCommas(const std::string& content, const OtherFile& file) {
  const auto is_unread = [](const Item& item) { return item.pose && !item.pose->allFinite(); };
  if (std::none_of(file.items.begin(), file.items.end(), is_unread)) return false;
  static const std::regex kComma("[\t\"]-?[0-9]+,[0-9]+[\t\"\r\n]");
  return std::regex_search(content.begin(),
                           content.begin() + long(std::min<std::size_t>(content.size(), 20000)), kComma);
}

bool isSameTarget(const Item& a, const Item& b) {
  return a.pose && b.pose && (*a.pose - *b.pose).cwiseAbs().maxCoeff() < kSamePose;
}

/// Leaves out what stands twice: an InstrumentMarker in two lists, a placement in two runs.
void dropRepeated(OtherFile& file) {
  std::multimap<std::string, std::size_t> kept;
  std::vector<Item> items;
  for (auto& item : file.items) {
    const Eigen::Vector3d p =
        item.pose ? Eigen::Vector3d(item.pose->topRightCorner<3, 1>()) : Eigen::Vector3d::Zero();
    const std::string key = formatted("%.3f %.3f %.3f ", p.x(), p.y(), p.z()) + item.name;
    const auto [begin, end] = kept.equal_range(key);
    const bool is_there = item.kind == Kind::target && std::any_of(begin, end, [&](const auto& entry) {
                            return isSameTarget(items[entry.second], item);
                          });
    if (is_there) continue;
    if (item.kind == Kind::target) kept.emplace(key, items.size());
    items.push_back(std::move(item));
  }
  if (items.size() < file.items.size())
    file.notes.push_back(formatted("%d targets stand in it twice with one pose and count once",
                                   int(file.items.size() - items.size())));
  file.items = std::move(items);
}

}  // namespace

OtherFile finished(OtherFile file, const std::filesystem::path& path) {
  if (file.items.size() > kMostItems) throw Error("holds more than 100000 items", path.string());
  if (file.items.empty())
    throw Error("holds no targets, pulses or landmarks (" + file.words + ")", path.string());
  nameItems(file);
  dropRepeated(file);
  return file;
}

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
    if (format.write || format.write_folder) names += (names.empty() ? "" : ", ") + format.name;
  return names;
}

const Format& writtenFormat(const std::string& name) {
  for (const auto& format : formats())
    if (format.name == name && (format.write || format.write_folder)) return format;
  throw Error("no such format: " + name, {}, "one of " + namesOfWritten());
}

bool isKnown(const std::string& content) {
  if (startsWith(content, "\xEF\xBB\xBF")) return isKnown(content.substr(3));
  if (!knownButNotRead(content).empty() && !startsWith(content, "PK")) return true;
  return std::any_of(formats().begin(), formats().end(),
                     [&](const Format& format) { return format.recognises && format.recognises(content); }) ||
         savedBySpreadsheet(content);
}

OtherFile readOther(const std::filesystem::path& path, const T1* t1) {
  if (!std::filesystem::exists(path)) throw Error("file does not exist", path.string(), "check the path");
  const bool is_folder = std::filesystem::is_directory(path);
  if (is_folder || isSessionArchive(path)) return readFileSet(path, t1);
  if (!std::filesystem::is_regular_file(path)) throw Error("is no file", path.string());
  if (std::filesystem::file_size(path) > kLargestFile_bytes)
    throw Error("is larger than 64 MB, which no list of targets is", path.string());
  return readOtherText({readWholeFile(path), path, t1});
}

OtherFile readOtherText(Source source) {
  source.content = plainText(std::move(source.content));
  const std::string file = source.path.string();
  if (trimmed(source.content).empty()) throw Error("is empty", file, "export it again");
  if (const auto why = knownButNotRead(source.content); !why.empty()) throw Error(why, file);
  const auto table = savedBySpreadsheet(source.content);
  if (table) source.content = *table;
  for (const auto& format : formats()) {
    if (!format.recognises || !format.recognises(source.content)) continue;
    OtherFile read = format.read(source);
    read.format = format.name;
    if (table)
      read.notes.push_back("its cells are separated as a spreadsheet does it; decimal commas are points");
    if (holdsDecimalCommas(source.content, read))
      throw Error("its numbers have decimal commas", file, "export it with decimal points");
    return finished(std::move(read), source.path);
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
