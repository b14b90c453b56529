#pragma once
// IgtlPeer: one client of the server. It reads requests at a bounded rate, and sends whole messages, each in
// one write. While a message is only partly sent, newer frames are dropped for this client.

#include <deque>
#include <memory>

#include "facenav/core/timestamp.h"
#include "facenav/links/igtl_content.h"
#include "facenav/links/igtl_reader.h"
#include "facenav/links/live_output.h"

namespace facenav::links {

/// A TDATA or QTDATA stream that the client started.
struct IgtlStream {
  bool is_on = false;
  int interval_ms = 0;
  Timestamp sent;
};

class IgtlPeer : public std::enable_shared_from_this<IgtlPeer> {
 public:
  /// Takes the connected, non-blocking socket and closes it at the end.
  IgtlPeer(int socket, std::string address);
  ~IgtlPeer();
  IgtlPeer(const IgtlPeer&) = delete;
  IgtlPeer& operator=(const IgtlPeer&) = delete;

  int socket() const { return socket_; }
  /// poll() events that it waits for now.
  short events();
  /// Reads what has come, as far as the rate allows; call nextRequest() afterwards.
  void read();
  std::optional<IgtlMessage> nextRequest();
  /// Sends the frame's poses, and the streams that the client started. Returns false if it was dropped.
  bool send(const LiveFrame& frame);
  /// Sends a message besides the frames. It waits, in order, if another one is not sent yet.
  void reply(IgtlMessage message);
  /// Sends a whole message that is already encoded.
  void reply(std::shared_ptr<const Bytes> message);
  /// Marks that content is being made for the client; its next requests wait until then.
  void setWaitsForContent(bool is_waiting) { waits_for_content_ = is_waiting; }
  /// Sends what waits, as far as the socket takes it.
  void flush();
  /// True if it has gone, speaks another protocol, or has not taken anything for half a minute.
  bool isOver() const;
  /// Reason for isOver() in words.
  std::string reason() const { return reason_; }

  /// Bytes that wait for the client in this program.
  std::size_t waiting() const;
  /// "127.0.0.1:50112".
  const std::string& address() const { return address_; }
  /// "127.0.0.1:50112, header 2".
  std::string words() const;
  int headerVersion() const { return header_version_; }
  bool& takesTransforms() { return takes_transforms_; }
  IgtlStream& tools() { return tools_; }
  IgtlStream& placedTools() { return placed_tools_; }

 private:
  bool write(const IgtlMessage& message);
  bool mayBurden() const;
  bool mayAsk() const;
  void end(const std::string& reason);

  int socket_;
  std::string address_, reason_;
  IgtlReader reader_;
  int header_version_ = 1;
  bool takes_transforms_ = true, waits_for_content_ = false;
  IgtlStream tools_, placed_tools_;
  std::deque<std::shared_ptr<const Bytes>> pending_;  // the first may be partly sent
  std::size_t sent_of_first_ = 0;
  double allowance_;  // bytes that may be read now
  Timestamp refilled_, moved_;
  std::uint32_t id_ = 0;
};

/// Messages of the frame's tools, for TDATA and QTDATA. A lost tool is left out.
IgtlMessage toolsMessage(const LiveFrame& frame, bool is_placed, int header_version);
/// TRANSFORM of a pose: lost is the identity and, with header 2, TransformValid 0.
IgtlMessage transformMessage(const LivePose& pose, std::uint64_t stamp, int header_version);

}  // namespace facenav::links
