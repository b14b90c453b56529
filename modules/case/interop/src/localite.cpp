#include <cmath>
#include <pugixml.hpp>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/interop/axes.h"
#include "readers.h"
#include "text.h"
#include "xml_text.h"

// Localite's lists: InstrumentMarker, TriggerMarkers, EntryTarget, GUMMarkers. Read as XML, since the order
// of attributes and the line breaks vary.

namespace facenav::interop {
namespace {

std::optional<Eigen::Matrix4d> matrixOf(const pugi::xml_node& marker) {
  const auto node = marker.child("Matrix4D");
  if (!node) return std::nullopt;
  Eigen::Matrix4d matrix;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column)
      matrix(row, column) = numberOrNan(node.attribute(formatted("data%d%d", row, column).c_str()).value());
  return matrix;
}

/// Sets the pose, unless the marker was never set: then its rotation is the identity and `set` is false.
void readPose(const pugi::xml_node& marker, Item& item) {
  const auto matrix = matrixOf(marker);
  const bool is_set = marker.attribute("set").as_bool(true);
  if (!matrix)
    item.reason = "the file has no matrix for it";
  else if (isUnturned(*matrix))
    item.reason = "not tracked: its rotation is the identity";
  else if (!is_set)
    item.reason = "not set";
  else
    item.pose = toFaceNav(*matrix, CoilAxes::localite);
}

Space spaceOf(const std::string& words) {
  if (words == "RAS") return Space::ras;
  if (words == "LPS") return Space::lps;
  if (words == "MNI") return Space::mni;
  if (words == "Talairach") return Space::talairach;
  return Space::unknown;
}

void addInstrumentMarkers(const pugi::xml_node& root, OtherFile& file) {
  int number = 0;
  for (const auto& outer : root.children()) {
    if (outer.type() != pugi::node_element) continue;
    ++number;
    const std::string type = outer.attribute("type").as_string("InstrumentMarker");
    if (type != "InstrumentMarker") {
      file.notes.push_back(
          formatted("element %d is a '%s' and is left out", number, type.substr(0, 40).c_str()));
      continue;
    }
    pugi::xml_node marker = outer.child("Marker");
    if (!marker) marker = outer.child("InstrumentMarker");  // Navigator 4
    if (!marker) marker = outer;
    Item item;
    item.where = formatted("marker %d", number);
    item.name = marker.attribute("description").value();
    if (const std::string more = trimmed(marker.attribute("additionalInformation").value()); !more.empty())
      item.values["additionalInformation"] = more;
    readPose(marker, item);
    file.items.push_back(item);
  }
}

/// Time in a file name of Localite, "TriggerMarkers_Coil0_20260305102030125.xml": when it was saved.
std::optional<double> timeInName(const std::filesystem::path& path) {
  const std::string stem = path.stem().string();
  const auto last = stem.find_last_not_of("0123456789");
  const std::string d = last == std::string::npos ? stem : stem.substr(last + 1);
  if (d.size() < 14) return std::nullopt;
  return clockOf(d.substr(0, 4) + "-" + d.substr(4, 2) + "-" + d.substr(6, 2),
                 d.substr(8, 2) + ":" + d.substr(10, 2) + ":" + d.substr(12, 2));
}

/// Start of a list with a time of day alone: the last one before it was saved.
std::optional<double> startOf(const std::string& time_of_day, const std::optional<double>& saved_s) {
  constexpr double kDay_s = 86400, kMinute_s = 60;
  auto start_s = clockOf(saved_s ? dateOf(*saved_s) : "1970-01-01", time_of_day);
  if (start_s && saved_s && *start_s > *saved_s + kMinute_s) *start_s -= kDay_s;
  return start_s;
}

/// Value of a pulse; nothing for NaN and for 0, which stands for "not measured".
std::optional<double> measured(const Item& item, const char* key) {
  const auto found = item.values.find(key);
  if (found == item.values.end()) return std::nullopt;
  const auto value = valueIn(found->second);
  return value && *value > 0 ? value : std::nullopt;
}

void readValues(const pugi::xml_node& marker, Item& item) {
  for (const auto& value : marker.child("ResponseValues").children("Value"))
    item.values[value.attribute("key").value()] = value.attribute("response").value();
  item.didt_a_per_us = measured(item, "valueA");
  item.intensity_pct = measured(item, "amplitudeA");
  item.mep_uv = measured(item, "mepAmplitude");
  if (!item.mep_uv) item.mep_uv = measured(item, "response");
}

void addTriggerMarkers(const pugi::xml_node& root, const Source& source, OtherFile& file) {
  const auto saved_s = timeInName(source.path);
  const auto start_s = startOf(root.attribute("startTime").value(), saved_s);
  if (!saved_s) file.notes.push_back("its name holds no date: the pulses have times of day only");
  int number = 0;
  for (const auto& marker : root.children("TriggerMarker")) {
    Item item;
    item.kind = Kind::pulse;
    item.where = formatted("marker %d", ++number);
    item.name = marker.attribute("description").value();
    if (trimmed(item.name).empty()) item.name = formatted("pulse %d", number);
    readPose(marker, item);
    readValues(marker, item);
    const auto after_ms = valueIn(marker.attribute("recordingTime").value());
    if (start_s && after_ms) {
      const double clock_s = *start_s + *after_ms / 1000.0;
      if (saved_s) item.clock_s = clock_s;
      item.onset_s = *after_ms / 1000.0;
      item.time = (saved_s ? dateOf(clock_s) + " " : "") + timeOf(clock_s);
    }
    file.items.push_back(item);
  }
}

void addEntryTargets(const pugi::xml_node& root, OtherFile& file) {
  int number = 0;
  for (const auto& node : root.select_nodes(".//Marker")) {
    const auto marker = node.node();
    const auto place = marker.child("ColVec3D");
    ++number;
    if (!place || !marker.attribute("set").as_bool(true)) continue;
    Item item;
    item.kind = Kind::landmark;
    item.where = formatted("marker %d", number);
    item.name = trimmed(marker.attribute("description").value());
    const std::string role = marker.parent().name();
    item.name = item.name.empty() ? role : item.name + " (" + role + ")";
    item.place_mm = Eigen::Vector3d(numberOrNan(place.attribute("data0").value()),
                                    numberOrNan(place.attribute("data1").value()),
                                    numberOrNan(place.attribute("data2").value()));
    file.items.push_back(item);
  }
}

}  // namespace

bool isLocalite(const std::string& content) {
  const std::string start = content.substr(0, 100000);  // comments may stand first
  for (const char* root :
       {"<InstrumentMarkerList", "<TriggerMarkerList", "<EntryTargetList", "<GUMMarkerList"})
    if (contains(start, root)) return true;
  return false;
}

OtherFile readLocalite(const Source& source) {
  pugi::xml_document document;
  const auto root = rootOf(document, source);
  const std::string name = root.name();
  OtherFile file;
  file.space_words = root.attribute("coordinateSpace").value();
  file.space = spaceOf(file.space_words);
  file.words = "Localite " + name + (file.space_words.empty() ? "" : ", " + file.space_words);
  if (name == "TriggerMarkerList")
    addTriggerMarkers(root, source, file);
  else if (name == "EntryTargetList")
    addEntryTargets(root, file);
  else if (name == "InstrumentMarkerList" || name == "GUMMarkerList")
    addInstrumentMarkers(root, file);
  else
    refuseFile(source.path, "",
               "its root element is '" + name + "', a list of Localite's markers was expected");
  return file;
}

namespace {

void appendMatrix(pugi::xml_node marker, const Eigen::Matrix4d& matrix) {
  auto node = marker.append_child("Matrix4D");
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column)
      setText(node, formatted("data%d%d", row, column).c_str(),
              formatted("%.17g", matrix(row, column) + 0.0));
}

Eigen::Matrix4d localiteOf(const Item& item) {
  return item.mri_T_coil ? fromFaceNav(item.mri_T_coil->matrix(), CoilAxes::localite)
                         : Eigen::Matrix4d(Eigen::Matrix4d::Identity());
}

void appendTargets(pugi::xml_document& document, const Order& order) {
  auto root = document.append_child("InstrumentMarkerList");
  setText(root, "coordinateSpace", "RAS");
  int index = 0;
  for (const auto* target : targetsOf(order)) {
    auto outer = root.append_child("InstrumentMarker");
    setText(outer, "alwaysVisible", "false");
    setText(outer, "index", std::to_string(index));
    setText(outer, "selected", index++ == 0 ? "true" : "false");
    auto marker = outer.append_child("Marker");
    setText(marker, "additionalInformation", "");
    setText(marker, "color", "#ff0000");
    setText(marker, "description", target->name);
    setText(marker, "set", "true");
    appendMatrix(marker, localiteOf(*target));
  }
}

void appendValues(pugi::xml_node marker, const Item& pulse) {
  auto values = marker.append_child("ResponseValues");
  const auto append = [&](const char* key, const std::optional<double>& number) {
    auto value = values.append_child("Value");
    setText(value, "key", key);
    setText(value, "response", number ? formatted("%.17g", *number) : "NaN");
  };
  append("valueA", pulse.didt_a_per_us);
  append("response", pulse.mep_uv);
  append("amplitudeA", pulse.intensity_pct);
}

void appendParameters(pugi::xml_node root) {
  auto parameters = root.append_child("ResponseParameters");
  setText(parameters, "selectedResponseChannel", "0");
  const char* const kRows[][5] = {{"response", "51200.0", "-51200.0", "Response", "uV"},
                                  {"valueA", "200.0", "0.0", "Value A (di/dt)", "A/us"},
                                  {"amplitudeA", "100.0", "0.0", "Amplitude A", "%"}};
  const char* const kNames[] = {"id", "maxValue", "minValue", "name", "unit"};
  for (const auto& row : kRows) {
    auto description = parameters.append_child("responseDescription");
    for (int i = 0; i < 5; ++i) setText(description, kNames[i], row[i]);
  }
}

void appendPulses(pugi::xml_document& document, const Order& order, double start_s) {
  auto root = document.append_child("TriggerMarkerList");
  setText(root, "coordinateSpace", "RAS");
  setText(root, "isOnlineReading", "false");
  setText(root, "startTime", timeOf(start_s));
  appendParameters(root);
  for (const auto& item : order.items) {
    if (item.kind != Kind::pulse) continue;
    auto marker = root.append_child("TriggerMarker");
    setText(marker, "color", "#ffafaf");
    setText(marker, "description", item.name);
    setText(marker, "recordingTime", formatted("%.0f", (item.clock_s.value_or(start_s) - start_s) * 1000.0));
    setText(marker, "selected", "false");
    setText(marker, "set", item.mri_T_coil ? "true" : "false");
    setText(marker, "visibility", "true");
    appendValues(marker, item);
    appendMatrix(marker, localiteOf(item));
  }
}

}  // namespace

Written writeLocalite(const Order& order) {
  pugi::xml_document document;
  Written written;
  std::optional<double> start_s;
  bool has_pulses = false;
  for (const auto& item : order.items) {
    has_pulses |= item.kind == Kind::pulse;
    if (item.clock_s && (!start_s || *item.clock_s < *start_s)) start_s = item.clock_s;
  }
  if (has_pulses) {
    appendPulses(document, order, start_s.value_or(0.0));
    written.notes.push_back("targets are in another file of Localite: export without --session");
    if (start_s)
      written.notes.push_back(
          "Localite takes the date of pulses from the file's name: TriggerMarkers_Coil0_" +
          digitsOf(*start_s) + ".xml");
  } else {
    appendTargets(document, order);
    written.notes.push_back("Localite and SimNIBS want the file name InstrumentMarker and 17 digits, as " +
                            std::string("InstrumentMarker") +
                            digitsOf(clockOf(order.utc.substr(0, 10), order.utc.substr(11, 12)).value_or(0)) +
                            ".xml");
  }
  written.content = xmlText(document);
  return written;
}

}  // namespace facenav::interop
