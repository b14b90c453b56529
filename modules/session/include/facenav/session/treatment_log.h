#pragma once
// TreatmentLog: writes what a running Session does into sessions/<UTC time>/ of the case (poses.csv,
// guidance.csv, events.jsonl). It has its own thread, so that neither tracking nor the window waits for the
// disk. It notes losses, finds, faults and the recording's end by itself; the caller adds pulses, chosen
// targets and overrides.

#include <filesystem>
#include <memory>
#include <string>

#include "facenav/session/session.h"

namespace facenav::session {

class TreatmentLog {
 public:
  /// Only the log may take() states of `session`. Its thread reads the session until the log is destroyed and
  /// keeps it alive until then. Throws Error when the case folder cannot be written to.
  TreatmentLog(std::shared_ptr<Session> session, const std::filesystem::path& case_folder);
  /// Writes what is left, syncs it to the disk and joins.
  ~TreatmentLog();
  TreatmentLog(const TreatmentLog&) = delete;
  TreatmentLog& operator=(const TreatmentLog&) = delete;

  /// Returns at once. Must not contain a patient's name.
  void addEvent(const std::string& event, const std::string& detail = {});
  /// A TMS pulse and where the coil was: "3, on_target, 0.8 mm, 2 deg" or "3, lost".
  void addPulse();
  int pulses() const;
  const std::filesystem::path& folder() const;
  /// Why writing stopped (disk full, ..); empty if it did not.
  std::string failure() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::session
