#pragma once
// Protocol: what a course of treatment gives in each session, under a name and a version. A protocol is a
// JSON file that many cases may use. Each case has its own copy (CASE/protocol.json), so that later edits of
// the original do not change it. Other numbers need another version.
//
// {"name": "M1 10 Hz", "version": 2, "pulses": 3000, "trains": 60, "frequency_hz": 10, "pause_s": 25,
// "output_pct": 52, "threshold_pct": 80, "sessions": 15, "note": ""}
//
// name, version and pulses are required; the other keys are optional.

#include <filesystem>
#include <optional>
#include <string>

#include "facenav/core/file_access.h"
#include "facenav/guidance/dose.h"

namespace facenav::casefile {

struct Protocol {
  std::string name;
  int version = 1;
  guidance::Dose dose;          // dose of one session
  std::optional<int> sessions;  // number of sessions in the course
  std::string note;

  bool operator==(const Protocol& other) const;
  bool operator!=(const Protocol& other) const { return !(*this == other); }
};

/// Reads a protocol. Throws Error naming file and key: missing or malformed, or outside the ranges of
/// guidance::Dose.
Protocol readProtocol(const std::filesystem::path& path);
/// Writes the file completely or not at all. Throws Error, also for a protocol without a name.
void writeProtocol(const Protocol& protocol, const std::filesystem::path& path,
                   FileAccess access = FileAccess::owner_only);

/// Writes a protocol that has every key, for a person to change; its numbers are an example and no advice.
/// setProtocol refuses it until it has another name. Throws Error if the file exists.
void writeProtocolTemplate(const std::filesystem::path& path);

/// Returns the case's protocol; nothing if it has none. Throws as readProtocol does.
std::optional<Protocol> protocolOf(const std::filesystem::path& case_folder);
/// Sets the case's protocol. Throws Error if the case has one of the same name and version with other
/// numbers (a changed protocol needs a new version), and for the unchanged example.
void setProtocol(const std::filesystem::path& case_folder, const Protocol& protocol);
/// Removes the case's protocol; its sessions keep what they recorded.
void removeProtocol(const std::filesystem::path& case_folder);

}  // namespace facenav::casefile
