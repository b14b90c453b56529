#include "answer_keeper.h"

#include "facenav/casefile/session_pulses.h"
#include "facenav/casefile/twitches.h"

namespace facenav::session {

bool AnswerKeeper::isOpen(int newest) const {
  std::lock_guard lock(mutex_);
  return newest > earlier_ && (given_.empty() || given_.back().pulse < newest);
}

bool AnswerKeeper::add(int newest, const Answer& answer) {
  if (!isOpen(newest)) return false;
  std::lock_guard lock(mutex_);
  const bool replaces = reopened_ && reopened_->pulse == newest && !std::holds_alternative<double>(answer);
  if (replaces) unwritten_.push_back({newest, reopened_->answer, true});
  reopened_.reset();
  given_.push_back({newest, answer});
  unwritten_.push_back(given_.back());
  return true;
}

bool AnswerKeeper::takeBack() {
  std::lock_guard lock(mutex_);
  if (given_.empty()) return false;
  Given last = given_.back();
  given_.pop_back();
  last.is_taken_back = true;
  if (std::holds_alternative<double>(last.answer))
    reopened_ = last;
  else
    unwritten_.push_back(last);
  return true;
}

void AnswerKeeper::write(const std::filesystem::path& session_folder, const Given& given) {
  if (const double* mep_uv = std::get_if<double>(&given.answer)) {
    casefile::MepEdit edit{given.pulse, *mep_uv, {}, "typed", ""};
    if (given.is_taken_back) edit.mep_uv.reset();
    casefile::editMeps(session_folder, {edit});
  } else {
    const bool has_twitched = std::get<bool>(given.answer);
    casefile::keepTwitch(session_folder, given.pulse,
                         given.is_taken_back ? std::nullopt : std::optional(has_twitched));
  }
}

void AnswerKeeper::write(const std::filesystem::path& session_folder, int kept) {
  for (;;) {
    Given first;
    {
      std::lock_guard lock(mutex_);
      if (unwritten_.empty() || unwritten_.front().pulse > kept) return;
      first = unwritten_.front();
    }
    write(session_folder, first);
    std::lock_guard lock(mutex_);
    unwritten_.pop_front();
  }
}

}  // namespace facenav::session
