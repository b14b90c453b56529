#pragma once
// ReviewEditor: changes to a kept session, each of which can be taken back: pulses excluded with a reason or
// taken in again, MEPs entered or imported. Each change and each undo is written to the session at once, as
// one more line of its history.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "facenav/casefile/session_pulses.h"

namespace facenav::steps {

class ReviewEditor {
 public:
  /// Begins with another session; forgets what could be undone.
  void open(const std::filesystem::path& session_folder);
  const std::filesystem::path& folder() const { return folder_; }

  // Each throws Error, and then nothing is changed.
  void exclude(const std::vector<int>& numbers, const std::string& reason, const std::string& by);
  void include(const std::vector<int>& numbers, const std::string& by);
  void setMeps(const std::vector<casefile::MepEdit>& edits);
  void undo();
  void redo();

  bool canUndo() const { return !done_.empty(); }
  bool canRedo() const { return !undone_.empty(); }
  /// "exclude 12 pulses", for the button; empty if there is none.
  std::string undoWords() const { return done_.empty() ? std::string() : done_.back().words; }
  std::string redoWords() const { return undone_.empty() ? std::string() : undone_.back().words; }

 private:
  /// Only one of the lists is filled.
  struct Change {
    std::vector<casefile::PulseEdit> pulses;
    std::vector<casefile::MepEdit> meps;
  };
  struct Step {
    Change forward, backward;
    std::string words;
  };
  void write(const Change& change) const;
  void take(Step step);

  std::filesystem::path folder_;
  std::vector<Step> done_, undone_;
};

}  // namespace facenav::steps
