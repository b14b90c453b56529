#include "commands/session_commands.h"

#include <poll.h>
#include <unistd.h>

#include <cstdio>
#include <nlohmann/json.hpp>
#include <sstream>

#include "facenav/coil_library/coil_library.h"
#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "json_output.h"

namespace facenav::app {
namespace {

using Json = nlohmann::ordered_json;

void say(const Json& line) { printJsonLine(line); }

Json toJson(const casefile::Pulse& pulse) {
  Json json{{"pulse", pulse.number},
            {"status", toString(pulse.status)},
            {"reason", pulse.reason},
            {"source", pulse.source},
            {"target", pulse.target ? pulse.target->name : ""}};
  if (!pulse.coil.empty()) json["coil"] = pulse.coil;
  if (pulse.intensity_pct) json["intensity_pct"] = *pulse.intensity_pct;
  if (pulse.offset) json["distance_mm"] = pulse.offset->distance_mm;
  return json;
}

double numberFrom(const std::string& text, const char* what) {
  if (const auto value = numberIn(text)) return *value;
  throw Error(std::string(what) + " is a number, not '" + text.substr(0, 40) + "'");
}

[[noreturn]] void refuseCommand(const std::string& line) {
  throw Error("not understood: '" + line.substr(0, 60) + "'", {}, "commands: " + sessionCommandWords());
}

void answer(const std::string& word, const std::string& value, steps::Treatment& treatment) {
  const bool is_twitch = word == "twitch";
  if (is_twitch && value != "y" && value != "n") throw Error("twitch is answered y or n");
  const bool is_kept = is_twitch ? treatment.log().answerPulse(value == "y")
                                 : treatment.log().answerPulse(numberFrom(value, "the MEP"));
  if (!is_kept) throw Error("there is no pulse yet, or no such MEP", {}, "give its amplitude in uV");
}

void setIntensity(const std::string& value, steps::Treatment& treatment) {
  const double pct = numberFrom(value, "the intensity");
  if (!(pct >= 0 && pct <= 100)) throw Error(formatted("an intensity of %g %% is not possible", pct));
  treatment.setIntensity(pct);
}

/// Adds a pulse; with two coils it must be known which one gave it.
void pressPulse(const std::string& coil, steps::Treatment& treatment) {
  const std::string second = treatment.secondCoilName();
  if (!coil.empty() && coil != treatment.coilName() && (second.empty() || coil != second))
    throw Error("there is no coil '" + coil.substr(0, 60) + "' in this session");
  if (coil.empty() && !treatment.knowsCoilOf("keyboard"))
    throw Error("two coils are followed", {}, "say which one gave it: pulse COIL");
  treatment.pressPulse(Timestamp::now(), coil);
}

void chooseSecondTarget(const std::string& name, steps::Treatment& treatment) {
  if (treatment.secondCoilName().empty()) throw Error("there is no second coil");
  treatment.chooseSecondTargetNamed(name);
}

void tellReading(const char* what, const guidance::TipReading& reading, const std::string& verdict,
                 steps::Treatment& treatment) {
  if (!verdict.empty() && verdict != "right" && verdict != "wrong")
    throw Error(std::string("the ") + what + " is judged right or wrong", {},
                "or give no such word, to read where it is");
  Json told{{what, inWords(reading)}, {"off_skin_mm", reading.off_skin_mm}};
  if (reading.nearest) {
    told["nearest"] = reading.nearest->name;
    told["off_place_mm"] = reading.off_place_mm;
  }
  if (reading.sigma_mm > 0) told["depth_sd_mm"] = reading.sigma_mm;
  say(told);
  if (!verdict.empty())
    treatment.judgeTip(verdict == "right" ? steps::TipVerdict::right : steps::TipVerdict::wrong, reading);
}

}  // namespace

std::string sessionCommandWords() {
  return "pause REASON, resume, target NAME, coil NAME, intensity PCT, mep UV, twitch y|n (of the newest "
         "pulse), check (the registration), tip (where the coil's tip is on the MRI's skin), tip right|wrong "
         "(a person's judgement of it), spot left|right X Y [right|wrong] (the same of a spot in a picture, "
         "px), note WORDS (an adverse event), pulse [COIL] (one was given now), second-target NAME, "
         "take NAME (a target that --accept offered, into the plan), end";
}

bool SessionCommands::obey(const std::string& line, steps::Treatment& treatment) {
  const auto blank = line.find(' ');
  const std::string word = line.substr(0, blank),
                    rest = blank == std::string::npos ? std::string() : line.substr(blank + 1);
  if (word == "end") return false;
  if (word == "pause")
    treatment.pause(report::noteWords(rest, "reason of the pause"));
  else if (word == "resume")
    treatment.resume();
  else if (word == "target")
    treatment.chooseTargetNamed(rest);
  else if (word == "take")
    orders_.take(rest, casefile::CaseStore::open(case_folder_), "");
  else if (word == "second-target")
    chooseSecondTarget(rest, treatment);
  else if (word == "coil")
    treatment.chooseCoil(coil_library::findCoil(coil_library_, rest).model);
  else if (word == "intensity")
    setIntensity(rest, treatment);
  else if (word == "mep" || word == "twitch")
    answer(word, rest, treatment);
  else if (word == "pulse")
    pressPulse(rest, treatment);
  else if (word == "check")
    treatment.checkRegistration();
  else if (word == "tip")
    judgeTip(rest, treatment);
  else if (word == "spot")
    judgeSpot(rest, treatment);
  else if (word == "note")
    treatment.log().addEvent(report::session_events::kAdverse, report::noteWords(rest, "note"));
  else
    refuseCommand(line);
  say({{"done", word}});
  return true;
}

/// Logs the position of the coil's tip on the MRI's skin with a person's judgement.
void SessionCommands::judgeTip(const std::string& verdict, steps::Treatment& treatment) {
  if (!tip_check_) tip_check_ = treatment.makeTipCheck();
  const auto reading = steps::readTip(*treatment.session().latest(), treatment.tip(), *tip_check_);
  if (!reading) throw Error("head or coil is lost", {}, "show both to the cameras");
  tellReading("tip", *reading, verdict, treatment);
}

/// Does the same for a spot in the newest pictures: "left 312 205 right".
void SessionCommands::judgeSpot(const std::string& words, steps::Treatment& treatment) {
  std::istringstream stream(words);
  std::string side, x, y, verdict;
  stream >> side >> x >> y >> verdict;
  if ((side != "left" && side != "right") || y.empty())
    throw Error("a spot is a picture and its pixel", {}, "spot left|right X Y [right|wrong]");
  if (!tip_check_) tip_check_ = treatment.makeTipCheck();
  const Eigen::Vector2d px(numberFrom(x, "X"), numberFrom(y, "Y"));
  const auto picture = side == "left" ? stereo::PictureSide::left : stereo::PictureSide::right;
  const auto reading =
      steps::readPickedSpot(*treatment.session().latest(), treatment.rig(), picture, px, *tip_check_);
  if (!reading)
    throw Error("the spot is not found in the other picture near the MRI's skin, or the head is lost", {},
                "choose a spot with detail that both cameras see");
  tellReading("spot", *reading, verdict, treatment);
}

bool SessionCommands::readInput(steps::Treatment& treatment) {
  pollfd input{STDIN_FILENO, POLLIN, 0};
  while (has_input_ && ::poll(&input, 1, 0) > 0) {
    char buffer[1024];
    const ssize_t size = ::read(STDIN_FILENO, buffer, sizeof buffer);
    if (size <= 0) has_input_ = false;  // standard input has ended; the session continues
    if (size > 0) input_.append(buffer, std::size_t(size));
  }
  for (std::size_t end; (end = input_.find('\n')) != std::string::npos;) {
    std::string line = input_.substr(0, end);
    input_.erase(0, end + 1);
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.empty()) continue;
    try {
      if (!obey(line, treatment)) return false;
    } catch (const Error& error) {
      say({{"error", error.what()}});
    }
  }
  return true;
}

namespace {

/// Why the head is withheld until a check passes or a person judges it; empty if it is not.
std::string headWithheldIn(const session::NavigationState& state) {
  const bool is_told = state.withheld && state.withheld->isOfAlignment();
  return is_told ? monitoring::bannerOf(*state.withheld) : std::string();
}

}  // namespace

void SessionCommands::tell(steps::Treatment& treatment) {
  for (const auto& pulse : treatment.log().takeKept()) say(toJson(pulse));
  const auto state = treatment.session().latest();
  if (state->check && state->check->number != told_check_) {
    told_check_ = state->check->number;
    say({{"check", state->check->hasPassed()}, {"words", inWords(*state->check)}});
  }
  if (session::isCameraAway(*state) != is_camera_away_) {
    is_camera_away_ = !is_camera_away_;
    say({{"cameras", is_camera_away_ ? "away" : "back"},
         {"words", is_camera_away_ ? session::rigFault(*state)->words() : ""}});
  }
  const std::string withheld = headWithheldIn(*state);
  if (state->frame >= 0 && withheld != told_withheld_) {
    told_withheld_ = withheld;
    say({{"withheld", told_withheld_}});
  }
  if (treatment.isCheckDue() != is_check_due_) {
    is_check_due_ = !is_check_due_;
    say({{"check_due", is_check_due_}});
  }
}

bool SessionCommands::look(steps::Treatment& treatment) {
  if (!has_begun_) {
    has_begun_ = true;
    const auto counts = treatment.log().counts();
    Json begin{{"session", treatment.log().folder().filename().string()},
               {"pulses", counts.on_target + counts.outside + counts.lost},
               {"paused", treatment.isPaused()}};
    if (const auto planned = treatment.plannedPulses()) begin["planned"] = *planned;
    say(begin);
  }
  const bool goes_on = readInput(treatment);
  tell(treatment);
  return goes_on;
}

}  // namespace facenav::app
