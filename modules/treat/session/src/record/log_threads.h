#pragma once
// The two threads of a TreatmentLog: one gives pulses and pictures their frames and never waits for the disk,
// the other writes. Private to session.

#include <atomic>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>

#include "answer_keeper.h"
#include "facenav/casefile/session_log.h"
#include "facenav/casefile/session_so_far.h"
#include "facenav/session/treatment_log.h"
#include "follow_on.h"
#include "state_changes.h"
#include "time_keeper.h"

namespace facenav::session {

/// What `follower` and `thread` share with the callers.
struct TreatmentLog::Implementation {
  struct Event {
    std::string name, detail;
  };

  Implementation(std::shared_ptr<Session> session_, const std::filesystem::path& case_folder,
                 std::shared_ptr<const registration::ScalpField> scalp, const TreatmentLogOptions& options);

  const std::shared_ptr<Session> session;
  const std::optional<casefile::SessionSoFar> so_far;  // set for a continued session
  casefile::SessionLog log;                            // used only by the thread once it runs
  const std::filesystem::path folder;
  const std::function<std::chrono::system_clock::time_point()> clock;
  std::atomic<bool> is_stopping{false};
  const std::unique_ptr<EvidenceKeeper> evidence;  // null: none is kept
  PulseKeeper pulses;
  PauseTimes pauses;
  AnswerKeeper answers;
  const Timestamp begun = Timestamp::now();
  mutable std::mutex mutex;  // guards the members below, up to `failure`
  std::condition_variable followed;
  std::deque<std::shared_ptr<const NavigationState>> unwritten;  // the oldest first, without pictures
  std::deque<Event> events;
  std::string failure, end_words;
  std::atomic<bool> has_followed_all{false};  // true after the session's last frame was followed
  std::thread follower;               // gives pulses and pictures their frames; never waits for the disk
  std::optional<FollowOn> follow_on;  // used only by `follower`; set by the first frame
  std::thread thread;                 // writes
  // Members used only by the writing thread.
  StateChanges changes;
  TimeKeeper times;
  bool has_noted_end = false;
  std::string evidence_fault;
  std::optional<Timestamp> broken;  // time since which writing fails
  std::optional<double> ahead_s;    // time of day minus the steady clock
  Timestamp retry;

  void follow();
  void run();
  std::shared_ptr<const NavigationState> nextRow();
  void writeEvents();
  void writeAll(bool is_last);
  void noteEnd();
  std::string endWords() const;
  Timestamp until() const { return {begun.s + session->elapsed_s()}; }
  void noteEvidence();
  void noteClock();
  std::shared_ptr<const NavigationState> asLogged(std::shared_ptr<const NavigationState> state);
  void write(const NavigationState& state);
  template <class Work>
  void tried(Work work);
  std::string faultWords(const std::exception& error) const;
  void setFailure(const std::string& words);
  void awaitPulses() const;
  void end();
};

}  // namespace facenav::session
