#pragma once
// ReviewEditor: changes to a stored session with undo: pulses excluded with a reason or included again, MEPs
// entered or imported. Each change and each undo is written to the session at once, as one more line of its
// history.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "facenav/casefile/session_pulses.h"

namespace facenav::steps {

class ReviewEditor {
 public:
  /// Opens another session and clears the undo list.
  void open(const std::filesystem::path& session_folder);
  const std::filesystem::path& folder() const { return folder_; }

  // The next functions throw Error, and then nothing is changed.
  void exclude(const std::vector<int>& numbers, const std::string& reason, const std::string& by);
  void include(const std::vector<int>& numbers, const std::string& by);
  void setMeps(const std::vector<casefile::MepEdit>& edits);
  void undo();
  void redo();

  bool canUndo() const { return !done_.empty(); }
  bool canRedo() const { return !undone_.empty(); }
  /// Label of the undo button: "exclude 12 pulses"; empty if there is nothing to undo.
  std::string undoWords() const { return done_.empty() ? std::string() : done_.back().words; }
  std::string redoWords() const { return undone_.empty() ? std::string() : undone_.back().words; }

 private:
  /// One change; only one of the lists is filled.
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
