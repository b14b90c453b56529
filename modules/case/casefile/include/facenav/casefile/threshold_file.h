#pragma once
// ThresholdFile: one search for the motor threshold, stored in CASE/thresholds/<UTC time>.jsonl. Its first
// line names method and muscle; each answer is one more line, synced to the disk before keep() returns, so
// that a search can continue after a crash, kill -9 or a power cut. A wrong answer is taken back by another
// line, not removed.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "facenav/guidance/target.h"
#include "facenav/stimulation/threshold.h"

namespace facenav::casefile {

struct KeptAnswer {
  stimulation::ThresholdAnswer answer;
  std::optional<double> mep_uv = {};  // nothing: answered with yes or no
  std::string utc = {};
};

struct KeptThreshold {
  std::filesystem::path path;
  std::string started_utc;  // 2026-11-23T14:05:09.123Z
  stimulation::ThresholdMethod method = stimulation::ThresholdMethod::bayes;
  std::string muscle;                      // as typed; empty: not given
  std::optional<guidance::Target> target;  // where the coil was held: name, pose and places; nothing: unknown
  std::vector<KeptAnswer> answers;         // without those taken back
  std::vector<std::string> problems;       // descriptions of damaged lines, which are left out

  std::vector<stimulation::ThresholdAnswer> plain() const;
};

/// Reads a search. Throws Error if there is no such file, or if it is not one of a threshold.
KeptThreshold readThreshold(const std::filesystem::path& path);
/// Reads the searches of a case, oldest first. Skips unreadable files with a logged warning.
std::vector<KeptThreshold> readThresholds(const std::filesystem::path& case_folder);

class ThresholdFile {
 public:
  /// Makes a new file, 0600. Throws Error.
  static ThresholdFile begin(const std::filesystem::path& case_folder, stimulation::ThresholdMethod method,
                             const std::string& muscle, const std::optional<guidance::Target>& target = {});
  /// Opens a search to continue it. Throws Error as readThreshold does.
  static ThresholdFile open(const std::filesystem::path& path);
  ~ThresholdFile();
  ThresholdFile(ThresholdFile&&) noexcept;
  ThresholdFile& operator=(ThresholdFile&&) noexcept;

  const KeptThreshold& kept() const;
  /// Writes an answer with the current time; durable when it returns. Throws Error (disk full, ..): then
  /// nothing is stored.
  void keep(KeptAnswer answer);
  /// Takes the last answer back. Throws Error if there is none.
  void takeBack();

 private:
  struct Implementation;
  explicit ThresholdFile(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::casefile
