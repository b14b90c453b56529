#pragma once
// Protocol: what a course of treatment gives in each session, under a name and a version. A protocol is a
// JSON file that many cases may use; each case holds its own copy (CASE/protocol.json), so that a session
// counts against numbers that nobody changes behind its back. Other numbers need another version.
//
//   {"name": "M1 10 Hz", "version": 2, "pulses": 3000, "trains": 60, "frequency_hz": 10, "pause_s": 25,
//    "output_pct": 52, "threshold_pct": 80, "sessions": 15, "note": ""}
//
// name, version and pulses are required; a key that is absent is not stated.

#include <filesystem>
#include <optional>
#include <string>

#include "facenav/core/file_access.h"
#include "facenav/guidance/dose.h"

namespace facenav::casefile {

struct Protocol {
  std::string name;
  int version = 1;
  guidance::Dose dose;          // of one session
  std::optional<int> sessions;  // of the course
  std::string note;

  bool operator==(const Protocol& other) const;
  bool operator!=(const Protocol& other) const { return !(*this == other); }
};

/// Throws Error naming file and key: missing or malformed, or out of the ranges of guidance::Dose.
Protocol readProtocol(const std::filesystem::path& path);
/// Writes the file completely or not at all. Throws Error, also for a protocol without a name.
void writeProtocol(const Protocol& protocol, const std::filesystem::path& path,
                   FileAccess access = FileAccess::by_umask);

/// The protocol that the case refers to; nothing if it has none. Throws as readProtocol does.
std::optional<Protocol> protocolOf(const std::filesystem::path& case_folder);
/// Makes it the case's protocol. Throws Error when the case has one of the same name and version with other
/// numbers: a changed protocol needs a new version.
void setProtocol(const std::filesystem::path& case_folder, const Protocol& protocol);
/// The case has none from now on; its sessions keep what they recorded.
void removeProtocol(const std::filesystem::path& case_folder);

}  // namespace facenav::casefile
