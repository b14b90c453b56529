#pragma once
// TreatmentLog: writes what a running Session does into sessions/<UTC time>/ of the case (poses.csv,
// guidance.csv, events.jsonl), on a thread of its own, so that neither tracking nor the window waits for the
// disk. Losses, finds, faults and the recording's end become events by themselves; pulses, chosen targets and
// overrides are told.

#include <filesystem>
#include <memory>
#include <string>

#include "facenav/session/session.h"

namespace facenav::session {

class TreatmentLog {
 public:
  /// The only one that may take() states of `session`; its thread reads the session until the log has gone,
  /// and keeps it so long. Throws Error when the case folder cannot be written to.
  TreatmentLog(std::shared_ptr<Session> session, const std::filesystem::path& case_folder);
  /// Writes what is left, forces it to the disk and joins.
  ~TreatmentLog();
  TreatmentLog(const TreatmentLog&) = delete;
  TreatmentLog& operator=(const TreatmentLog&) = delete;

  /// Returns at once. No patient's name in it.
  void addEvent(const std::string& event, const std::string& detail = {});
  /// A TMS pulse, with where the coil was: "3, on_target, 0.8 mm, 2 deg" or "3, lost".
  void addPulse();
  int pulses() const;
  const std::filesystem::path& folder() const;
  /// Why writing stopped (disk full, ..); empty while all is well.
  std::string failure() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::session
