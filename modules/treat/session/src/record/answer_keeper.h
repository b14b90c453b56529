#pragma once
// AnswerKeeper: the muscle's answers to the pulses of a running session, one a pulse, and their way into the
// session's files. Private to session.

#include <deque>
#include <filesystem>
#include <mutex>
#include <optional>
#include <variant>
#include <vector>

namespace facenav::session {

/// An MEP in uV, or whether the muscle twitched.
using Answer = std::variant<double, bool>;

class AnswerKeeper {
 public:
  /// `earlier`: number of the last pulse of an earlier run; those are not asked about.
  explicit AnswerKeeper(int earlier) : earlier_(earlier) {}

  /// Returns true if the newest pulse has no answer yet; 0: there is no pulse.
  bool isOpen(int newest) const;
  /// Adds the newest pulse's answer. Returns false if it has one, or if there is no pulse.
  bool add(int newest, const Answer& answer);
  /// Takes the last answer back; its pulse can be answered again while it is the newest. A twitch is taken
  /// back in the files, too; an MEP, which was measured, stays there until another answer replaces it.
  /// Returns false without one.
  bool takeBack();
  /// Writes the answers of the pulses up to `kept`, which are in the file. Throws Error; the rest is written
  /// by the next call.
  void write(const std::filesystem::path& session_folder, int kept);

 private:
  struct Given {
    int pulse = 0;
    Answer answer;
    bool is_taken_back = false;
  };
  static void write(const std::filesystem::path& session_folder, const Given& given);

  const int earlier_;
  mutable std::mutex mutex_;
  std::vector<Given> given_;       // in force, in the order of the pulses
  std::optional<Given> reopened_;  // an MEP that the next answer replaces
  std::deque<Given> unwritten_;
};

}  // namespace facenav::session
