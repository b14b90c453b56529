#pragma once
// SessionLog: what a treatment session leaves in sessions/<UTC time>/ of its case: poses.csv, guidance.csv
// and events.jsonl, appended line by line while it runs. A line is handed to the system at once (a crash of
// the program loses none); events, and everything at close, are also forced to the disk. For one thread at a
// time.

#include <filesystem>
#include <memory>
#include <string>

#include "facenav/casefile/poses_csv.h"
#include "facenav/guidance/guidance_csv.h"

namespace facenav::casefile {

class SessionLog {
 public:
  /// Makes sessions/<UTC time>/ in the case folder (with a counter behind it when that second is taken).
  /// Throws Error when it cannot be written.
  explicit SessionLog(const std::filesystem::path& case_folder);
  ~SessionLog();
  SessionLog(SessionLog&&) noexcept;
  SessionLog& operator=(SessionLog&&) noexcept;

  const std::filesystem::path& folder() const;
  void add(const PoseRow& row);
  void add(const guidance::GuidanceRow& row);
  /// One line {"utc": .., "event": .., "detail": ..}. No patient's name in it.
  void addEvent(const std::string& event, const std::string& detail = {});
  /// Forces everything to the disk; may take milliseconds.
  void sync();

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::casefile
