#include "igtl_server.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "facenav/core/error.h"
#include "facenav/core/log.h"
#include "igtl_orders.h"

namespace facenav::links {
namespace {

constexpr std::size_t kMostIgtlClients = 8;

std::string wordsOfPlace(const sockaddr_in& place) {
  char text[INET_ADDRSTRLEN] = {};
  ::inet_ntop(AF_INET, &place.sin_addr, text, sizeof text);
  return std::string(text) + ":" + std::to_string(ntohs(place.sin_port));
}

IgtlMessage sentMessage(const std::string& type, const std::string& device, Bytes content) {
  IgtlMessage sent;
  sent.type = type;
  sent.device = device;
  sent.stamp = igtlStamp(std::chrono::system_clock::now());
  sent.content = std::move(content);
  return sent;
}

IgtlMessage status(IgtlStatusCode code, const std::string& name, const std::string& text) {
  return sentMessage("STATUS", "FaceNav", statusContent({int(code), 0, name, text}));
}

bool isOneOf(const std::string& word, std::initializer_list<const char*> words) {
  return std::any_of(words.begin(), words.end(), [&](const char* each) { return word == each; });
}

}  // namespace

IgtlServer::IgtlServer(const std::string& name, const IgtlPlaceToListen& place, LiveContent content,
                       LiveIncoming incoming)
    : ThreadedOutput(name), incoming_(std::move(incoming)), content_(std::move(content), [this] { wake(); }) {
  try {
    listen(place);
    start();
  } catch (...) {
    if (listening_ >= 0) ::close(listening_);
    throw;
  }
  if (place.address != "127.0.0.1")
    logWarning("poses, MRI and surfaces can be read by every computer that reaches " + place.address +
               ", port " + std::to_string(port_));
}

IgtlServer::~IgtlServer() {
  content_.stop();
  stop();
  peers_.clear();
  ::close(listening_);
}

void IgtlServer::listen(const IgtlPlaceToListen& place) {
  sockaddr_in at{};
  at.sin_family = AF_INET;
  at.sin_port = htons(std::uint16_t(place.port));
  if (::inet_pton(AF_INET, place.address.c_str(), &at.sin_addr) != 1)
    throw Error("'" + place.address + "' is no address", name(), "give it as numbers, 192.168.0.5");
  listening_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  const int on = 1;
  ::setsockopt(listening_, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  if (listening_ < 0 || ::bind(listening_, reinterpret_cast<const sockaddr*>(&at), sizeof at) != 0 ||
      ::listen(listening_, int(kMostIgtlClients)) != 0)
    throw Error(std::string("cannot be served on port ") + std::to_string(place.port) + " (" +
                    std::strerror(errno) + ")",
                name(), "choose another port, or end the program that uses it");
  socklen_t size = sizeof at;
  ::getsockname(listening_, reinterpret_cast<sockaddr*>(&at), &size);
  port_ = ntohs(at.sin_port);
}

void IgtlServer::accept() {
  sockaddr_in from{};
  socklen_t size = sizeof from;
  const int socket =
      ::accept4(listening_, reinterpret_cast<sockaddr*>(&from), &size, SOCK_CLOEXEC | SOCK_NONBLOCK);
  if (socket < 0) return;
  if (peers_.size() >= kMostIgtlClients) {
    ::close(socket);
    return;
  }
  peers_.push_back(std::make_shared<IgtlPeer>(socket, wordsOfPlace(from)));
  logInfo("OpenIGTLink: " + wordsOfPlace(from) + " is connected");
}

void IgtlServer::work() {
  std::vector<pollfd> waiting{{listening_, POLLIN, 0}};
  for (const auto& peer : peers_) waiting.push_back({peer->socket(), peer->events(), 0});
  waitFor(waiting);
  for (std::size_t i = 0; i < peers_.size(); ++i) {
    const short events = waiting[i + 1].revents;
    if (events & POLLOUT) peers_[i]->flush();
    if (events & (POLLIN | POLLHUP | POLLERR)) peers_[i]->read();
    while (auto request = peers_[i]->nextRequest()) answer(*peers_[i], *request);
  }
  if (auto frame = takeFrame()) serve(*(frame_ = std::move(frame)));
  takePulses();  // OpenIGTLink has no message for them
  sendContents();
  if (waiting[0].revents != 0) accept();
  dropGone();
}

void IgtlServer::serve(const LiveFrame& frame) {
  for (const auto& peer : peers_) {
    const bool is_sent = peer->send(frame);
    count(is_sent, !is_sent, peer->waiting());
  }
}

void IgtlServer::finish(const LiveFrame& frame) { serve(frame); }

void IgtlServer::sendContents() {
  for (auto& order : content_.takeMade()) {
    const auto peer = order.peer.lock();
    if (!peer) continue;
    peer->setWaitsForContent(false);
    if (order.message)
      peer->reply(order.message);
    else
      peer->reply(status(IgtlStatusCode::not_found, "NotFound", order.type + " " + order.name));
  }
}

void IgtlServer::dropGone() {
  std::vector<std::string> words;
  for (std::size_t i = peers_.size(); i-- > 0;) {
    words.push_back(peers_[i]->words());
    if (!peers_[i]->isOver()) continue;
    const std::string why = peers_[i]->reason();
    logInfo("OpenIGTLink: " + words.back() + ": " + (why.empty() ? "takes nothing: dropped" : why));
    words.pop_back();
    peers_.erase(peers_.begin() + std::ptrdiff_t(i));
  }
  if (words == told_) return;
  told_ = words;
  setReceivers(std::move(words));
}

void IgtlServer::answer(IgtlPeer& peer, const IgtlMessage& request) {
  if (request.type.size() < 5 || request.type[3] != '_') return takeOrders(peer, request);
  const std::string verb = request.type.substr(0, 3);
  std::string type = request.type.substr(4);
  // The field holds 12 letters: the protocol's library asks for GET_TRANS, others cut the word.
  if (isOneOf(type, {"TRANS", "TRANSFOR"})) type = "TRANSFORM";
  if (verb == "GET") return answerGet(peer, type, request.device);
  if (verb == "STT" || verb == "STP") answerStart(peer, type, request, verb == "STT");
}

/// Hands over what a message orders. A COMMAND is always answered, another order only if it is refused.
void IgtlServer::takeOrders(IgtlPeer& peer, const IgtlMessage& message) {
  auto found = ordersIn(message, incoming_);
  for (auto& order : found.orders) {
    order.from = peer.address();
    order.arrived = Timestamp::now();
    if (incoming_.receive) incoming_.receive(order);
  }
  if (!found.is_order) return;
  if (message.type == "COMMAND")
    return peer.reply(
        sentMessage("RTS_COMMAND", message.device,
                    commandContent({found.id, found.refusal, found.refusal.empty() ? "taken" : "refused"})));
  const bool is_off = !(message.type == "STRING" ? incoming_.takes_commands : incoming_.takes_targets);
  if (!found.refusal.empty())
    peer.reply(status(is_off ? IgtlStatusCode::disabled : IgtlStatusCode::not_found,
                      is_off ? "Disabled" : "NotFound", found.refusal));
}

void IgtlServer::answerGet(IgtlPeer& peer, const std::string& type, const std::string& device) {
  if (isOneOf(type, {"IMAGE", "POLYDATA", "POINT"})) {
    const bool is_ordered = content_.order({peer.shared_from_this(), type, device, peer.headerVersion()});
    peer.setWaitsForContent(is_ordered);
    if (!is_ordered) peer.reply(status(IgtlStatusCode::busy, "Busy", "ask again"));
    return;
  }
  if (type == "STATUS")
    return peer.reply(frame_ ? status(IgtlStatusCode::ok, "OK", frame_->state)
                             : status(IgtlStatusCode::not_ready, "NotReady", "no frame yet"));
  if (frame_ && isOneOf(type, {"TDATA", "QTDATA"}))
    return peer.reply(toolsMessage(*frame_, type == "QTDATA", peer.headerVersion()));
  if (frame_ && type == "STRING") {
    auto sent = sentMessage("STRING", "State", stringContent({frame_->state}));
    sent.stamp = igtlStamp(frame_->utc);
    return peer.reply(std::move(sent));
  }
  if (frame_ && isOneOf(type, {"TRANSFORM", "POSITION"}))
    for (const auto& pose : frame_->poses) {
      if (pose.name != device) continue;
      auto sent = transformMessage(pose, igtlStamp(frame_->utc), peer.headerVersion());
      if (type == "TRANSFORM") return peer.reply(std::move(sent));
      if (!pose.pose) break;  // a place alone cannot say that it is lost
      sent.type = type;
      sent.content = positionContent(placeOf(*pose.pose));
      return peer.reply(std::move(sent));
    }
  peer.reply(status(IgtlStatusCode::not_found, "NotFound", type + " " + device));
}

void IgtlServer::answerStart(IgtlPeer& peer, const std::string& type, const IgtlMessage& request,
                             bool is_start) {
  const bool is_known = isOneOf(type, {"TDATA", "QTDATA", "TRANSFORM"});
  const auto start = is_start ? readStart(request.content) : std::optional(IgtlStart());
  if (is_known && start) {
    if (type == "TRANSFORM")
      peer.takesTransforms() = is_start;
    else
      (type == "TDATA" ? peer.tools() : peer.placedTools()) = {is_start, start->interval_ms, {}};
  }
  peer.reply(sentMessage("RTS_" + (type == "TRANSFORM" ? "TRANS" : type), request.device,
                         answerContent(is_known && start ? 0 : 1)));
}

}  // namespace facenav::links
