#include "commands/output_option.h"

#include <cstdio>

#include "typed_values.h"
#include "wrong_usage.h"

namespace facenav::app {

void addSendOptions(CLI::App& verb, OutputChoice& choice) {
  verb.add_option("--address", choice.address,
                  "address of this computer that the OpenIGTLink server listens on; 0.0.0.0: all of them. "
                  "Everyone who reaches it can read poses, MRI and surfaces")
      ->capture_default_str();
  verb.add_option(
          "--send", choice.send,
          "also sends poses, state and pulses: osc:[HOST:]PORT or json:[HOST:]PORT (UDP), lsl[:STREAM] "
          "(markers), invesalius:[HOST:]PORT[:robot=ADDRESS] (its relay; asks to connect to a robot "
          "only with an address); may be repeated")
      ->allow_extra_args(false)
      ->check(understoodBy(links::requireLiveOutput));
}

void addAcceptOption(CLI::App& verb, OutputChoice& choice, const std::string& condition) {
  verb.add_option("--accept", choice.accept,
                  condition +
                      "takes from its clients targets (TRANSFORM or POINT named Target_*; they are "
                      "offered, never chosen), commands (start, stop, pulse), or targets,commands; default: "
                      "nothing")
      ->check(understoodBy([](const std::string& words) { links::incomingFrom(words); }));
}

void addOutputOptions(CLI::App& verb, OutputChoice& choice) {
  verb.add_option_function<std::string>(
          "--serve",
          [&choice](const std::string& port) {
            choice.is_served = true;
            if (!port.empty()) choice.port = std::stoi(port);
          },
          "serves the poses by OpenIGTLink on this port (18944), for NaviNIBS, 3D Slicer and others")
      ->expected(0, 1)
      ->type_name("[PORT]")
      ->check(understoodBy([](const std::string& port) {
        if (!port.empty()) links::requireLiveOutput("igtl:" + port);
      }));
  addAcceptOption(verb, choice, "with --serve: ");
  addSendOptions(verb, choice);
}

std::shared_ptr<steps::LiveOutputs> openOutputs(const OutputChoice& choice, bool is_quiet,
                                                const links::LiveIncoming& incoming) {
  if (!choice.accept.empty() && !choice.is_served)
    throw WrongUsage("--accept is for a server", "give --serve, too");
  auto words = choice.send;
  if (choice.is_served)
    words.insert(words.begin(), "igtl:" + choice.address + ":" + std::to_string(choice.port));
  if (words.empty()) return nullptr;
  auto outputs = std::make_shared<steps::LiveOutputs>();
  for (const auto& each : words) {
    outputs->open(each, incoming);
    if (!is_quiet) std::fprintf(stderr, "sending to %s\n", each.c_str());
  }
  return outputs;
}

}  // namespace facenav::app
