#pragma once
// Where poses, state and pulses are sent while a verb tracks: --serve, --address, --send.

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "facenav/treat/live_outputs.h"

namespace facenav::app {

struct OutputChoice {
  bool is_served = false;
  int port = links::kIgtlPort;
  std::string address = "127.0.0.1";
  std::vector<std::string> send;  // words of links::openLiveOutput
  std::string accept;             // words of links::incomingFrom; empty: nothing is taken from clients
};

/// Adds --serve [PORT], --accept, --address and --send.
void addOutputOptions(CLI::App& verb, OutputChoice& choice);
/// Adds --accept. `condition`: "with --serve: ", or empty for a verb that always serves.
void addAcceptOption(CLI::App& verb, OutputChoice& choice, const std::string& condition);
/// Adds --address and --send, for a verb that always serves.
void addSendOptions(CLI::App& verb, OutputChoice& choice);
/// Opens the outputs and says so on stderr; null if none is chosen. Throws Error if one cannot be opened.
/// `incoming`: what the server takes from its clients.
std::shared_ptr<steps::LiveOutputs> openOutputs(const OutputChoice& choice, bool is_quiet,
                                                const links::LiveIncoming& incoming = {});

}  // namespace facenav::app
