#pragma once
// PulseFile: pulses.jsonl of a running session. One line per pulse, synced to the disk before keep() returns.
// A crash, kill -9 or a power cut can only cut short a line whose keep() has not returned; readers ignore it.
// One thread at a time.

#include <filesystem>
#include <memory>

#include "facenav/casefile/pulse.h"

namespace facenav::casefile {

class PulseFile {
 public:
  enum class Begin { fresh, go_on };
  /// Opens the file. `fresh` makes pulses.jsonl (0600) and throws Error if it exists; `go_on` appends to the
  /// existing one. Throws Error if it cannot be written.
  explicit PulseFile(const std::filesystem::path& session_folder, Begin begin = Begin::fresh);
  ~PulseFile();
  PulseFile(const PulseFile&) = delete;
  PulseFile& operator=(const PulseFile&) = delete;

  /// Writes a pulse; durable when it returns. Throws Error (disk full, ..): then nothing of the pulse is in
  /// the file, and the caller may try again. If the file or its folder was removed, it is made again with all
  /// pulses so far.
  void keep(const Pulse& pulse);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::casefile
