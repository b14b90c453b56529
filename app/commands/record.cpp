// facenav record --rig NAME --seconds S -o RECORDING: live cameras -> a recording.

#include <cstdio>

#include "commands/commands.h"
#include "commands/live_option.h"
#include "facenav/setup/record_live.h"
#include "typed_values.h"

namespace facenav::app {
namespace {

struct RecordVerb {
  LiveChoice cameras;
  steps::RecordRequest request;
  std::string capture;  // "dots", "plain"
};

void runRecord(Context& context, RecordVerb verb) {
  std::error_code ignored;
  if (std::filesystem::exists(verb.request.folder, ignored) &&
      !std::filesystem::is_empty(verb.request.folder, ignored))
    throw Error("exists already and is not empty", verb.request.folder.string(), "choose another folder");
  const auto source = openLive(verb.cameras, context);
  verb.request.frames_per_s = verb.cameras.frames_per_s();
  if (verb.capture == "dots") verb.request.capture = askForCapture(*source);
  verb.request.keeps_first_as_plain = verb.capture == "plain";
  const auto outcome = steps::recordLive(*source, verb.request, context.monitor);
  if (!context.is_quiet) std::printf("%s: %s\n", verb.request.folder.c_str(), outcome.words().c_str());
  if (!outcome.ended_by.empty() && !context.monitor.isCancelled())
    throw Error(outcome.ended_by + "; what was recorded before is kept", verb.request.folder.string());
}

}  // namespace

void addRecord(CLI::App& app, Context& context) {
  auto* verb = app.add_subcommand(
      "record", "live cameras -> a recording that align, track, calibrate-coil and rig check read");
  const auto request = std::make_shared<RecordVerb>();
  addLiveOptions(*verb, request->cameras);
  addVerifyingCoilOptions(*verb, request->cameras);
  verb->add_option("--seconds", request->request.seconds, "how long; Ctrl-C ends it earlier and keeps it")
      ->capture_default_str()
      ->check(CLI::Range(0.1, 7200.0));
  verb->add_option("--capture", request->capture,
                   "still pair for the alignment: dots (asks for the projector on, then off) or plain (the "
                   "first pair)")
      ->check(CLI::IsMember({"dots", "plain"}));
  verb->add_option("-o,--output", request->request.folder, "recording folder to write")
      ->required()
      ->check(folderToMake());
  verb->callback([&context, request] { runRecord(context, *request); });
}

}  // namespace facenav::app
