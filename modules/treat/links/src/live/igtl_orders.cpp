#include "igtl_orders.h"

#include <algorithm>
#include <cctype>

#include "big_endian.h"
#include "facenav/core/error.h"

namespace facenav::links {
namespace {

constexpr std::size_t kLibraryName = 128, kSpecifiedName = 20;  // bytes of a command's name
constexpr std::size_t kMostTargets = 100;                       // in one message
constexpr const char* kCommands[] = {"start", "stop", "pulse"};

bool isTarget(const std::string& name) {
  const std::string prefix = kTargetPrefix;
  return name.size() > prefix.size() && name.compare(0, prefix.size(), prefix) == 0;
}

/// Reads "start", "stop", "pulse" or "pulse COIL"; nothing for other words.
std::optional<LiveOrder> commandIn(const std::string& text) {
  const auto isBlank = [](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; };
  const auto begin = std::find_if_not(text.begin(), text.end(), isBlank);
  const auto end = std::find_if_not(text.rbegin(), text.rend(), isBlank).base();
  if (begin >= end) return std::nullopt;
  const std::string words(begin, end);
  LiveOrder order;
  order.name = words.substr(0, words.find(' '));
  for (char& c : order.name) c = char(std::tolower(static_cast<unsigned char>(c)));
  const bool is_known = std::any_of(std::begin(kCommands), std::end(kCommands),
                                    [&](const char* each) { return order.name == each; });
  if (words.size() > order.name.size()) order.coil = words.substr(order.name.size() + 1);
  if (!is_known || (!order.coil.empty() && order.name != "pulse")) return std::nullopt;
  return order;
}

void addCommand(const std::optional<LiveOrder>& order, const LiveIncoming& accepted, IgtlOrders& found) {
  found.is_order = true;
  if (!accepted.takes_commands)
    found.refusal = "commands are not accepted";
  else if (!order)
    found.refusal = "unknown command: start, stop, pulse and pulse COIL are taken";
  else
    found.orders.push_back(*order);
}

void addTarget(LiveOrder order, const LiveIncoming& accepted, IgtlOrders& found) {
  found.is_order = true;
  if (!accepted.takes_targets) {
    found.refusal = "targets are not accepted";
    return;
  }
  order.kind = LiveOrder::Kind::target;
  if (found.orders.size() < kMostTargets) found.orders.push_back(std::move(order));
}

void addPoints(const IgtlMessage& message, const LiveIncoming& accepted, IgtlOrders& found) {
  const auto points = readPoints(message.content);
  if (!points) return;
  for (const auto& point : *points) {
    LiveOrder order;
    // Slicer names the points of a list F-1, F-2; the list itself is the device.
    if (isTarget(point.name))
      order.name = point.name;
    else if (isTarget(message.device))
      order.name = points->size() > 1 ? message.device + " " + point.name : message.device;
    else
      continue;
    order.place_mm = point.position_mm;
    addTarget(std::move(order), accepted, found);
  }
}

}  // namespace

Bytes commandContent(const IgtlCommand& command) {
  BigEndianWriter writer;
  writer.put(command.id, 4);
  writer.putText(command.name.substr(0, kLibraryName - 1), kLibraryName);
  writer.put(std::uint64_t(command.encoding), 2);
  writer.put(command.text.size(), 4);
  writer.putText(command.text);
  return writer.bytes;
}

std::optional<IgtlCommand> readCommand(const Bytes& content) {
  for (const std::size_t name_size : {kLibraryName, kSpecifiedName}) {
    BigEndianReader reader(content);
    IgtlCommand command;
    command.id = std::uint32_t(reader.take(4));
    command.name = reader.takeName(name_size);
    command.encoding = int(reader.take(2));
    const auto size = std::size_t(reader.take(4));
    if (!reader.isGood() || reader.left() != size) continue;
    command.text = reader.takeName(size);
    return command;
  }
  return std::nullopt;
}

IgtlOrders ordersIn(const IgtlMessage& message, const LiveIncoming& accepted) {
  IgtlOrders found;
  if (message.type == "COMMAND") {
    const auto command = readCommand(message.content);
    auto order = command ? commandIn(command->name) : std::nullopt;
    if (command && !order) order = commandIn(command->text);
    if (command) found.id = command->id;
    addCommand(order, accepted, found);
  } else if (message.type == "STRING") {
    const auto text = readString(message.content);
    addCommand(text ? commandIn(text->text) : std::nullopt, accepted, found);
  } else if (message.type == "TRANSFORM" && isTarget(message.device)) {
    LiveOrder order;
    order.name = message.device;
    if (const auto pose = readTransform(message.content)) {
      order.pose = pose->matrix();
      addTarget(std::move(order), accepted, found);
    }
  } else if (message.type == "POINT") {
    addPoints(message, accepted, found);
  }
  return found;
}

LiveIncoming incomingFrom(const std::string& words) {
  LiveIncoming incoming;
  std::size_t begin = 0;
  while (begin <= words.size()) {
    const auto end = std::min(words.find(',', begin), words.size());
    const std::string word = words.substr(begin, end - begin);
    if (word == "targets")
      incoming.takes_targets = true;
    else if (word == "commands")
      incoming.takes_commands = true;
    else
      throw Error("unknown word '" + word + "' of --accept", {},
                  "give targets, commands or targets,commands");
    begin = end + 1;
  }
  return incoming;
}

}  // namespace facenav::links
