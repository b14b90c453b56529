#pragma once
// TREAT: the search for a case's motor threshold. Each answer is stored at once (casefile/threshold_file.h).
// `facenav threshold` and the window use it; an unfinished search can be continued.

#include <filesystem>
#include <map>
#include <string>

#include "facenav/casefile/kept_session.h"
#include "facenav/casefile/threshold_file.h"

namespace facenav::steps {

struct ThresholdRequest {
  std::filesystem::path case_folder;
  stimulation::ThresholdMethod method = stimulation::ThresholdMethod::bayes;
  std::string muscle = {};
  std::optional<guidance::Target> target = {};  // where the coil is held; recorded with the search
  bool is_new = false;                          // leaves an unfinished search unchanged and begins another
};

class MotorThreshold {
 public:
  /// Continues the case's newest search if it is unfinished and of this method and muscle (an empty muscle
  /// fits any), and not of another target; else begins one. Throws Error.
  explicit MotorThreshold(const ThresholdRequest& request);

  const stimulation::ThresholdState& state() const { return state_; }
  const casefile::KeptThreshold& kept() const { return file_.kept(); }
  /// True if answers of an earlier run were found.
  bool isResumed() const { return is_resumed_; }
  /// Returns "52.3 % (95 % interval ..), bayes, 9 responses of 18 pulses, FDI".
  std::string inWords() const;

  // The next functions are durable when they return. They throw Error: an impossible intensity, a negative
  // MEP, a full disk; nothing has changed then.
  void answer(double intensity_pct, bool has_response);
  /// Adds an MEP; it is a response from ThresholdRules::response_uv on.
  void answerWithMep(double intensity_pct, double mep_uv);
  void takeBack();

 private:
  void keep(const casefile::KeptAnswer& answer);

  casefile::ThresholdFile file_;
  stimulation::ThresholdState state_;
  bool is_resumed_ = false;
};

/// Extracts the answers from a session's pulses: those with an intensity and an MEP, or with a twitch
/// answered by key, in order, without the excluded ones.
std::vector<stimulation::ThresholdAnswer> thresholdAnswers(const casefile::SessionPulses& session,
                                                           const std::map<int, bool>& twitches);

}  // namespace facenav::steps
