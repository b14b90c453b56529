// facenav threshold CASE: the motor threshold, asked pulse by pulse on the terminal (or by another program,
// as JSON lines), or from the pulses of a session. Each answer is stored at once.

#include <cmath>
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>

#include "commands/commands.h"
#include "facenav/casefile/twitches.h"
#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/treat/motor_threshold.h"

namespace facenav::app {
namespace {

using Json = nlohmann::ordered_json;
using stimulation::ThresholdState;

struct ThresholdCall {
  steps::ThresholdRequest search;
  std::string method = "bayes", target;
  std::optional<std::string> session;
  bool is_json = false;
};

/// One line of answer from a person or a program.
struct Reply {
  enum class Kind { response, mep, take_back, quit } kind = Kind::response;
  bool has_response = false;
  double mep_uv = 0;
  std::optional<double> intensity_pct;  // empty: the requested one
};

[[noreturn]] void refuse(const std::string& line) {
  throw Error("not understood: '" + line.substr(0, 60) + "'", {},
              "answer y or n, an MEP as '120 uV', undo or quit; '@ 55' behind it if the output was 55 %");
}

Reply replyFromJson(const std::string& line) {
  const auto json = Json::parse(line, nullptr, false);
  if (!json.is_object()) refuse(line);
  Reply reply;
  const auto number = [&](const char* key) {
    return json.contains(key) && json[key].is_number() && isUsableNumber(json[key].get<double>());
  };
  const auto isTrue = [&](const char* key) { return json.contains(key) && json[key] == true; };
  if (number("intensity_pct")) reply.intensity_pct = json["intensity_pct"].get<double>();
  if (number("mep_uv")) {
    reply.kind = Reply::Kind::mep;
    reply.mep_uv = json["mep_uv"].get<double>();
  } else if (json.contains("response") && json["response"].is_boolean()) {
    reply.has_response = json["response"].get<bool>();
  } else if (isTrue("undo") || isTrue("quit")) {
    reply.kind = isTrue("undo") ? Reply::Kind::take_back : Reply::Kind::quit;
  } else {
    refuse(line);
  }
  return reply;
}

/// Reads "y", "no", "120 uV", "y @ 55", "undo", "quit", or a JSON object.
Reply replyFrom(const std::string& line) {
  const auto first = line.find_first_not_of(" \t\r");
  if (first != std::string::npos && line[first] == '{') return replyFromJson(line);
  std::istringstream words(line);
  std::string answer, word;
  words >> answer;
  Reply reply;
  if (answer == "y" || answer == "yes" || answer == "n" || answer == "no") {
    reply.has_response = answer[0] == 'y';
  } else if (answer == "undo" || answer == "quit" || answer == "q") {
    reply.kind = answer == "undo" ? Reply::Kind::take_back : Reply::Kind::quit;
  } else {
    const auto mep_uv = numberIn(answer);
    reply.kind = Reply::Kind::mep;
    if (!mep_uv || !(words >> word) || (word != "uV" && word != "uv")) refuse(line);
    reply.mep_uv = *mep_uv;
  }
  if (words >> word) {
    std::string typed;
    if (word != "@" || !(words >> typed) || !(reply.intensity_pct = numberIn(typed))) refuse(line);
  }
  return reply;
}

std::string jsonOf(const ThresholdState& state) {
  Json json{{"pulses", state.pulses}, {"responses", state.responses}};
  json["estimate_pct"] = state.estimate_pct ? Json(*state.estimate_pct) : Json();
  json["interval_pct"] = state.interval_pct ? Json(*state.interval_pct) : Json();
  json["next_pct"] = state.next_pct ? Json(*state.next_pct) : Json();
  json["done"] = state.isDone();
  json["above_output"] = state.is_above_output;
  return json.dump() + "\n";
}

void show(const ThresholdState& state, const std::string& words, bool is_json) {
  if (is_json)
    std::fputs(jsonOf(state).c_str(), stdout);
  else if (state.isDone())
    std::printf("done: %s\n", words.c_str());
  else
    std::printf("%s%s%s\n  next: %.0f %% of the output; response? [y, n, 120 uV, undo, quit]\n",
                words.c_str(), state.level.empty() ? "" : "; ", state.level.c_str(), *state.next_pct);
  std::fflush(stdout);
}

/// Applies a reply. Returns false if the person stops here.
bool take(steps::MotorThreshold& search, const Reply& reply) {
  const double intensity_pct = reply.intensity_pct.value_or(search.state().next_pct.value_or(0));
  if (reply.kind == Reply::Kind::quit) return false;
  if (reply.kind == Reply::Kind::take_back)
    search.takeBack();
  else if (reply.kind == Reply::Kind::mep)
    search.answerWithMep(intensity_pct, reply.mep_uv);
  else
    search.answer(intensity_pct, reply.has_response);
  return true;
}

void ask(const ThresholdCall& request, const Context& context) {
  steps::MotorThreshold search(request.search);
  if (search.isResumed() && !context.is_quiet)
    std::fprintf(stderr, "note: goes on with the search of %s, %zu answers are kept (--new begins another)\n",
                 search.kept().started_utc.c_str(), search.kept().answers.size());
  for (const auto& problem : search.kept().problems) std::fprintf(stderr, "note: %s\n", problem.c_str());
  show(search.state(), search.inWords(), request.is_json);
  std::string line;
  while (!search.state().isDone() && std::getline(std::cin, line)) {
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    try {
      if (!take(search, replyFrom(line))) break;
    } catch (const Error& error) {  // the person answers again
      std::fprintf(stderr, "facenav: %s\n", error.what());
      continue;
    }
    show(search.state(), search.inWords(), request.is_json);
  }
  if (!search.state().isDone() && !context.is_quiet)
    std::fprintf(stderr, "note: not finished, %zu answers are kept; the same command goes on\n",
                 search.kept().answers.size());
}

void showOfSession(const ThresholdCall& request, const std::filesystem::path& case_folder) {
  const auto folder = casefile::findSession(case_folder, *request.session);
  const auto answers =
      steps::thresholdAnswers(casefile::readSessionPulses(folder), casefile::readTwitches(folder));
  if (answers.empty())
    throw Error("no pulse of the session has both an intensity and an answer of the muscle", folder.string(),
                "enter MEPs or twitches first");
  const auto state = thresholdAfter(request.search.method, answers);
  show(state, inWords(state, request.search.method), request.is_json);
}

}  // namespace

void addThreshold(CLI::App& app, Context& context) {
  auto* verb = app.add_subcommand(
      "threshold", "the motor threshold, pulse by pulse: gives the next intensity, asks for the response");
  auto request = std::make_shared<ThresholdCall>();
  verb->add_option("CASE", request->search.case_folder, "case folder")->required();
  verb->add_option("--method", request->method,
                   "bayes: 20 pulses at most, with an interval; 5of10: the Rossini-Rothwell rule")
      ->check(CLI::IsMember({"bayes", "5of10"}))
      ->capture_default_str();
  verb->add_option("--muscle", request->search.muscle, "muscle and side, as the report shall name it");
  verb->add_option("--target", request->target,
                   "target of the plan where the coil is held: kept as the hotspot, for the dose by field");
  verb->add_option("--session", request->session,
                   "takes the pulses of this session in place of answers; '' for the newest");
  verb->add_flag("--new", request->search.is_new, "begins a new search, even if one is unfinished");
  verb->add_flag("--json", request->is_json, "one JSON object a line, after each answer");
  verb->callback([&context, request] {
    const auto store = casefile::CaseStore::open(request->search.case_folder);
    request->search.method = stimulation::thresholdMethodFrom(request->method);
    if (!request->target.empty()) request->search.target = store.targets().find(request->target);
    if (request->session) return showOfSession(*request, store.folder());
    ask(*request, context);
  });
}

}  // namespace facenav::app
