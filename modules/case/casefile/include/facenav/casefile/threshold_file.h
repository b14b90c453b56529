#pragma once
// ThresholdFile: one search for the motor threshold, kept in CASE/thresholds/<UTC time>.jsonl. Its first line
// names method and muscle; each answer is one more line, synced to the disk before keep() returns, so that a
// search goes on after a crash, kill -9 or a power cut. An answer that was wrong is taken back by a line, not
// removed.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

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
  std::string muscle;                 // as typed; empty: not stated
  std::vector<KeptAnswer> answers;    // without those taken back
  std::vector<std::string> problems;  // damaged lines, in words: they are left out

  std::vector<stimulation::ThresholdAnswer> plain() const;
};

/// Throws Error: no such file, or not one of a threshold.
KeptThreshold readThreshold(const std::filesystem::path& path);
/// The searches of a case, oldest first. Files that cannot be read are passed over with a logged warning.
std::vector<KeptThreshold> readThresholds(const std::filesystem::path& case_folder);

class ThresholdFile {
 public:
  /// Makes a new file, 0600. Throws Error.
  static ThresholdFile begin(const std::filesystem::path& case_folder, stimulation::ThresholdMethod method,
                             const std::string& muscle);
  /// To go on with a search. Throws Error as readThreshold does.
  static ThresholdFile open(const std::filesystem::path& path);
  ~ThresholdFile();
  ThresholdFile(ThresholdFile&&) noexcept;
  ThresholdFile& operator=(ThresholdFile&&) noexcept;

  const KeptThreshold& kept() const;
  /// Durable when it returns; the time is added. Throws Error (disk full, ..): then it is not kept.
  void keep(KeptAnswer answer);
  /// Takes the last answer back. Throws Error if there is none.
  void takeBack();

 private:
  struct Implementation;
  explicit ThresholdFile(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::casefile
