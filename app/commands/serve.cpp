// facenav serve RECORDING, or --rig NAME: tracks head and coil and sends their poses to other programs.

#include <cstdio>

#include "commands/commands.h"
#include "commands/live_option.h"
#include "commands/output_option.h"
#include "commands/two_coils.h"
#include "facenav/capture/recording.h"
#include "facenav/casefile/case_store.h"
#include "facenav/treat/serve_poses.h"
#include "json_output.h"
#include "typed_values.h"
#include "wrong_usage.h"

namespace facenav::app {
namespace {

struct ServeVerb {
  steps::ServeRequest request;
  LiveChoice cameras;
  OutputChoice outputs;
  bool is_json = false;
};

/// Lets the clients ask what --accept says; `orders` outlives the outputs.
links::LiveIncoming incomingOf(ServeVerb& verb, steps::LiveOrders& orders, const Context& context) {
  if (verb.outputs.accept.empty()) return {};
  const auto accepted = links::incomingFrom(verb.outputs.accept);
  if (accepted.takes_targets && !verb.request.track.case_folder)
    throw WrongUsage("targets of clients are judged by a case",
                     "give it with --case, or accept commands only");
  verb.request.orders = &orders;
  if (!context.is_quiet)
    verb.request.tell = [](const steps::OrderNews& news) {
      std::fprintf(stderr, "%s\n", news.words.c_str());
    };
  return orders.incoming(accepted.takes_commands, accepted.takes_targets);
}

/// Throws Error for what is missing, before a port opens and its receivers are named.
void requireInputs(const steps::TrackRequest& track) {
  capture::openRecording(track.recording);
  if (!track.case_folder) return;
  const auto store = casefile::CaseStore::open(*track.case_folder);
  if (!track.target.empty()) store.targets().find(track.target);
}

void serve(Context& context, ServeVerb verb) {
  steps::LiveOrders orders;
  auto& request = verb.request;
  const bool is_live = !verb.cameras.rig.empty() || !verb.cameras.left.empty();
  if (is_live == !request.track.recording.empty())
    throw WrongUsage(is_live ? "a recording and cameras are both given" : "it is not said what to track",
                     "give a RECORDING, or --rig NAME");
  if (is_live && request.track.case_folder)
    throw WrongUsage("live cameras are served here without a case",
                     "for a session of a case: facenav track --live RIG --case CASE --serve");
  if (!request.track.target.empty() && !request.track.case_folder)
    throw WrongUsage("a target belongs to a case", "give it with --case");
  if (!is_live) requireInputs(request.track);
  if (is_live) request.openCameras = [&verb, &context] { return openLive(verb.cameras, context); };
  const auto& methods = context.registrations;
  request.track.aligner = methods.aligners.defaultName();
  request.track.head_tracker = methods.head_trackers.defaultName();
  request.track.coil_tracker = methods.coil_trackers.defaultName();
  const auto& coil = verb.cameras.coil;
  if (!coil.words.empty())
    request.track.coil_file = coil_library::coilFileOf(coil.words, coil_library::coilLibrary(coil.library));
  request.track.second_coil_file = secondCoilFile(coil);
  if (!request.track.second_target.empty() && (!request.track.second_coil_file || !request.track.case_folder))
    throw WrongUsage("--second-target needs a second coil and a case", "give --coil twice, and --case");
  verb.outputs.is_served = true;
  request.outputs = openOutputs(verb.outputs, context.is_quiet, incomingOf(verb, orders, context));
  const auto outcome = steps::servePoses(methods, request, context.monitor);
  if (verb.is_json) return printJson({{"frames", outcome.frames}, {"dropped", outcome.dropped}});
  if (!context.is_quiet)
    std::printf("%lld frames served, %llu dropped before tracking\n", static_cast<long long>(outcome.frames),
                static_cast<unsigned long long>(outcome.dropped));
}

}  // namespace

void addServe(CLI::App& app, Context& context) {
  auto* verb = app.add_subcommand(
      "serve", "recording or live cameras -> poses of head and coil for other programs, by OpenIGTLink");
  const auto request = std::make_shared<ServeVerb>();
  verb->add_option("RECORDING", request->request.track.recording, "recording folder; or live cameras");
  addLiveOptions(*verb, request->cameras);
  addCoilsOption(*verb, request->cameras.coil,
                 "the coil, by name or its coil.json; with a rig its marker verifies the cameras");
  verb->add_option("--case", request->request.track.case_folder,
                   "with a recording: case folder; also serves the poses in the MRI, and MRI and surfaces on "
                   "request");
  verb->add_option("--target", request->request.track.target, "name of the target, for CoilToTarget");
  addSecondTargetOption(*verb, request->request.track.second_target);
  verb->add_option("--port", request->outputs.port, "port of the OpenIGTLink server; 0: any free one")
      ->capture_default_str()
      ->check(CLI::Range(0, 65535));
  addAcceptOption(*verb, request->outputs, {});
  addSendOptions(*verb, request->outputs);
  verb->add_option("--seconds", request->request.seconds, "how long; default: to the end, or until Ctrl-C")
      ->check(CLI::Range(0.1, 86400.0));
  verb->add_option("--speed", request->request.speed, "plays a recording slower or faster than it was")
      ->check(CLI::Range(0.05, 20.0))
      ->capture_default_str();
  verb->add_option("--passes", request->request.passes,
                   "plays a recording so often, forwards and backwards in turn; 0: without end")
      ->check(CLI::Range(0, 100000))
      ->capture_default_str();
  verb->add_flag("--json", request->is_json, "the result as JSON");
  verb->callback([&context, request] { serve(context, *request); });
}

}  // namespace facenav::app
