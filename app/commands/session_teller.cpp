#include "commands/session_teller.h"

#include <unistd.h>

#include <cstdio>

namespace facenav::app {
namespace {

constexpr double kLastsAtLeast_s = 0.33;

std::string wrongIn(const session::NavigationState& state) {
  std::string words = session::lossInWords(state);
  const std::string second = session::secondCoilLossInWords(state);
  if (!second.empty()) words += (words.empty() ? "" : "; ") + state.second->name + ": " + second;
  if (session::isCameraAway(state)) words += " (" + session::rigFault(state)->words() + ")";
  return words;
}

}  // namespace

void SessionTeller::look(const steps::Treatment& treatment) {
  const auto state = treatment.session().latest();
  if (is_quiet_ || state->frame < 0) return;
  const std::string wrong = wrongIn(*state);
  if (!has_begun_ || wrong != now_) since_ = Timestamp::now();
  now_ = wrong;
  const bool is_news = !has_begun_ || now_ != told_;
  if (has_begun_ && (!is_news || Timestamp::now() - since_ < kLastsAtLeast_s)) return;
  has_begun_ = true;
  told_ = now_;
  const char* clear = ::isatty(STDERR_FILENO) ? "\r\033[K" : "";  // clears the progress line
  std::fprintf(stderr, "%s%6.1f s: %s\n", clear, treatment.session().elapsed_s(),
               now_.empty() ? "head and coil tracked" : now_.c_str());
}

}  // namespace facenav::app
