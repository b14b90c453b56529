#pragma once
// Orders in the messages of a client: commands and targets.

#include <vector>

#include "facenav/links/igtl_content.h"
#include "facenav/links/live_order.h"

namespace facenav::links {

/// COMMAND and its answer, RTS_COMMAND, in which `name` is the error (empty: none).
struct IgtlCommand {
  std::uint32_t id = 0;
  std::string name, text;
  int encoding = 106;
};
Bytes commandContent(const IgtlCommand& command);
/// Reads a name of 128 bytes, as the protocol's library writes it, or of 20, as its specification says.
std::optional<IgtlCommand> readCommand(const Bytes& content);

/// What a message orders, and what the client is told.
struct IgtlOrders {
  bool is_order = false;          // the message is a command or a target
  std::vector<LiveOrder> orders;  // empty: none can be taken
  std::string refusal;            // why; empty: all are taken
  std::uint32_t id = 0;           // of a COMMAND
};
/// Reads the orders of a message; what is not accepted is refused.
IgtlOrders ordersIn(const IgtlMessage& message, const LiveIncoming& accepted);

}  // namespace facenav::links
