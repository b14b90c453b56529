#include "facenav/casefile/protocol.h"

#include <nlohmann/json.hpp>

#include "facenav/core/error.h"
#include "facenav/core/json_reader.h"
#include "facenav/core/plain_words.h"
#include "facenav/core/standard_output.h"
#include "facenav/core/whole_file.h"
#include "facenav/guidance/dose_json.h"

namespace facenav::casefile {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

constexpr char kExample[] = "example: change every number";

fs::path protocolFile(const fs::path& case_folder) { return case_folder / "protocol.json"; }

/// Throws Error for a protocol without a name or a positive version.
void requireNamed(const Protocol& protocol) {
  requireName(protocol.name, "the protocol's name");
  requireNote(protocol.note, "the protocol's note");
  if (protocol.version < 1) throw Error("a protocol's version starts at 1", {}, "give 1, 2, ..");
}

}  // namespace

bool Protocol::operator==(const Protocol& other) const {
  return name == other.name && version == other.version && dose == other.dose && sessions == other.sessions &&
         note == other.note;
}

Protocol readProtocol(const fs::path& path) {
  const JsonReader json = JsonReader::readFile(path);
  Protocol protocol;
  protocol.name = json.at("name").text();
  protocol.version = json.at("version").integer();
  if (protocol.version < 1) json.at("version").refuse("a whole number from 1 was expected");
  protocol.dose = guidance::readDose(json);
  if (json.has("sessions")) {
    protocol.sessions = json.at("sessions").integer();
    if (*protocol.sessions < 1) json.at("sessions").refuse("a whole number from 1 was expected");
  }
  if (json.has("note")) protocol.note = json.at("note").text();
  try {
    requireNamed(protocol);
  } catch (const Error& fault) {
    json.at("name").refuse(fault.what());
  }
  return protocol;
}

void writeProtocol(const Protocol& protocol, const fs::path& path, FileAccess access) {
  requireNamed(protocol);
  guidance::requireSensible(protocol.dose);
  Json json{{"name", protocol.name}, {"version", protocol.version}};
  for (const auto& [key, value] : guidance::doseNumbers(protocol.dose))
    value == double(int(value)) ? json[key] = int(value) : json[key] = value;
  if (protocol.sessions) json["sessions"] = *protocol.sessions;
  if (!protocol.note.empty()) json["note"] = protocol.note;
  writeWholeFile(path, json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n", access);
}

void writeProtocolTemplate(const fs::path& path) {
  if (!isStandardOutput(path) && fs::exists(path))
    throw Error("exists already", path.string(), "choose another name");
  Protocol example;
  example.name = kExample;
  example.dose.pulses = 3000;
  example.dose.trains = 60;
  example.dose.frequency_hz = 10;
  example.dose.pause_s = 25;
  example.dose.threshold_pct = 100;
  example.dose.output_pct = 50;
  example.sessions = 20;
  example.note =
      "pulses: in one session, over all trains. frequency_hz: within a train; 0: no fixed rate. "
      "pause_s: between trains. threshold_pct or output_pct: the strength; delete the other. "
      "A changed protocol needs a new version.";
  writeProtocol(example, path, FileAccess::by_umask);
}

std::optional<Protocol> protocolOf(const fs::path& case_folder) {
  if (!fs::exists(protocolFile(case_folder))) return std::nullopt;
  return readProtocol(protocolFile(case_folder));
}

void setProtocol(const fs::path& case_folder, const Protocol& protocol) {
  if (protocol.name == kExample)
    throw Error("this is the example, no protocol", {}, "give it your own name and numbers");
  const auto old = protocolOf(case_folder);
  if (old && old->name == protocol.name && old->version == protocol.version && *old != protocol)
    throw Error(
        "the case has version " + std::to_string(old->version) + " of '" + old->name + "' with other numbers",
        protocolFile(case_folder).string(), "give the changed protocol a new version");
  writeProtocol(protocol, protocolFile(case_folder), FileAccess::owner_only);
}

void removeProtocol(const fs::path& case_folder) {
  std::error_code fault;
  fs::remove(protocolFile(case_folder), fault);
  if (fault)
    throw Error("the protocol cannot be removed (" + fault.message() + ")",
                protocolFile(case_folder).string(), "check the folder's permissions");
}

}  // namespace facenav::casefile
