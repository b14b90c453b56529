#include <algorithm>
#include <map>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "folders.h"
#include "readers.h"
#include "text.h"

// A session folder of Localite. Every save writes each list anew under a name with its time, often two within
// milliseconds: the fullest list of a kind is read, the newest of those that are equally full.

namespace facenav::interop {
namespace {

struct List {
  std::string name;
  OtherFile file;
  std::size_t posed = 0;  // entries with a pose
};

bool isBetter(const List& a, const List& b) {
  if (a.file.items.size() != b.file.items.size()) return a.file.items.size() > b.file.items.size();
  if (a.posed != b.posed) return a.posed > b.posed;
  return lastOf(a.name) > lastOf(b.name);
}

/// The fullest list in files whose names begin so; `saves` counts them.
std::optional<List> fullest(const FileSet& files, const std::string& beginning, int& saves) {
  std::optional<List> best;
  std::string damaged;
  for (const auto& name : files.names()) {
    if (!startsWith(lastOf(name), beginning) || !endsWith(name, ".xml")) continue;
    List list{name, {}, 0};
    try {
      const std::string content = files.read(name);
      if (!isLocalite(content)) continue;
      list.file = readLocalite({content, files.path(name), nullptr});
    } catch (const Error& error) {
      damaged = error.what();
      continue;
    }
    ++saves;
    for (const auto& item : list.file.items) list.posed += item.pose || item.place_mm;
    if (!best || isBetter(list, *best)) best = std::move(list);
  }
  if (best && !damaged.empty()) best->file.notes.push_back("a save of it was left out: " + damaged);
  return best;
}

/// What two coils' entries of one pulse have in common: the time to a millisecond, else the place in the
/// list.
std::string keyOf(const Item& pulse) {
  if (pulse.clock_s) return formatted("%.3f s", *pulse.clock_s);
  const auto comma = pulse.where.rfind(", ");
  return comma == std::string::npos ? pulse.where : pulse.where.substr(comma + 2);
}

/// Both coils' lists hold every pulse; the coil that was not tracked has no pose there.
void joinCoils(const List& second, OtherFile& file) {
  int taken = 0, both = 0;
  std::map<std::string, std::size_t> of_first;
  for (std::size_t i = 0; i < file.items.size(); ++i)
    if (file.items[i].kind == Kind::pulse) of_first.emplace(keyOf(file.items[i]), i);
  for (const auto& other : second.file.items) {
    const auto found = of_first.find(keyOf(other));
    Item pulse = other;
    pulse.where = lastOf(second.name) + ", " + other.where;
    pulse.values["coil"] = "2";
    const bool is_alone = found == of_first.end();
    const bool has_first = !is_alone && file.items[found->second].pose;
    if (!is_alone && !has_first && other.pose) {
      file.items[found->second] = pulse;
      ++taken;
    } else if (is_alone || (has_first && other.pose)) {
      file.items.push_back(pulse);
      both += has_first;
    }
  }
  if (taken > 0) file.notes.push_back(formatted("%d pulses have the pose of coil 2", taken));
  if (both > 0)
    file.notes.push_back(formatted("both coils have a pose at %d pulses, and each comes in as one", both));
}

/// Takes the space of the first list. Throws Error if a later one has another.
void requireSameSpace(const List& list, OtherFile& all) {
  if (all.items.empty()) {
    all.space = list.file.space;
    all.space_words = list.file.space_words;
  }
  if (list.file.space_words != all.space_words)
    throw Error("its lists lie in '" + all.space_words + "' and in '" + list.file.space_words + "'",
                list.name, "choose one file");
}

void add(const List& list, OtherFile& all, int saves) {
  all.items.insert(all.items.end(), list.file.items.begin(), list.file.items.end());
  all.notes.insert(all.notes.end(), list.file.notes.begin(), list.file.notes.end());
  if (saves > 1)
    all.notes.push_back(formatted("%s is the fullest of %d saves: %d entries", lastOf(list.name).c_str(),
                                  saves, int(list.file.items.size())));
}

}  // namespace

bool isLocaliteSession(const FileSet& files) {
  return std::any_of(files.names().begin(), files.names().end(), [](const std::string& name) {
    if (!endsWith(name, ".xml")) return false;
    for (const char* beginning : {"InstrumentMarker", "TriggerMarkers_Coil", "GUMMarkers"})
      if (startsWith(lastOf(name), beginning)) return true;
    return false;
  });
}

OtherFile readLocaliteSession(const FileSet& files) {
  OtherFile all;
  all.format = "localite";
  for (const char* kind :
       {"InstrumentMarker", "GUMMarkers", "EntryTarget", "TriggerMarkers_Coil0", "TriggerMarkers_Coil1"}) {
    int saves = 0;
    auto list = fullest(files, kind, saves);
    if (!list || list->file.items.empty()) continue;
    if (const auto part = files.onDisk(list->name)) all.parts.push_back(*part);
    requireSameSpace(*list, all);
    const bool is_second = contains(list->name, "_Coil1_");
    const bool has_first = std::any_of(all.items.begin(), all.items.end(),
                                       [](const Item& item) { return item.kind == Kind::pulse; });
    if (is_second && has_first) {
      joinCoils(*list, all);
      continue;
    }
    if (is_second)
      for (auto& item : list->file.items) item.values["coil"] = "2";
    for (auto& item : list->file.items) item.where = lastOf(list->name) + ", " + item.where;
    add(*list, all, saves);
  }
  all.words = "Localite session" + (all.space_words.empty() ? "" : ", " + all.space_words);
  return all;
}

}  // namespace facenav::interop
