#pragma once
// SessionLog: the files of a treatment session in sessions/<UTC time>/ of its case: poses.csv, guidance.csv
// and events.jsonl, appended line by line; with a second coil also poses_coil2.csv and guidance_coil2.csv.
// Each line goes to the operating system at once, so a crash of the program loses none. Events, and
// everything at close, are also synced to the disk. One thread at a time.

#include <filesystem>
#include <memory>
#include <string>

#include "facenav/casefile/poses_csv.h"
#include "facenav/guidance/guidance_csv.h"

namespace facenav::casefile {

class SessionLog {
 public:
  /// Makes sessions/<UTC time>/ in the case folder (with a counter appended if that second is taken). Throws
  /// Error when it cannot be written.
  explicit SessionLog(const std::filesystem::path& case_folder);
  /// Appends to the files of an earlier session, after a crash or a closed window. Throws Error when they
  /// cannot be written, or when another program writes them.
  static SessionLog goOn(const std::filesystem::path& session_folder);
  ~SessionLog();
  SessionLog(SessionLog&&) noexcept;
  SessionLog& operator=(SessionLog&&) noexcept;

  const std::filesystem::path& folder() const;
  void add(const PoseRow& row);
  void add(const guidance::GuidanceRow& row);
  /// Adds lines of a second coil to its own tables, which the first line makes.
  void addSecond(const PoseRow& row, const std::string& coil);
  void addSecond(const guidance::GuidanceRow& row, const std::string& coil);
  /// Appends one line {"utc": .., "event": .., "detail": ..}. Must not contain a patient's name.
  void addEvent(const std::string& event, const std::string& detail = {});
  /// Makes the session's files again, with all their content, if its folder was removed. Returns false if
  /// they exist. Throws Error.
  bool putBack();
  /// Syncs everything to the disk; may take milliseconds.
  void sync();

 private:
  struct Implementation;
  explicit SessionLog(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::casefile
