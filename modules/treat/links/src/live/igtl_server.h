#pragma once
// IgtlServer: an OpenIGTLink server for several clients, each with a socket of its own. Every client gets the
// frame's poses as TRANSFORM; TDATA, QTDATA, POSITION, STATUS, STRING, POINT, POLYDATA and IMAGE only if it
// asks. Commands and targets of a client are handed over if they are accepted (live_order.h).

#include <memory>

#include "facenav/links/live_order.h"
#include "igtl_content_thread.h"
#include "igtl_peer.h"
#include "threaded_output.h"

namespace facenav::links {

struct IgtlPlaceToListen {
  std::string address = "127.0.0.1";
  int port = kIgtlPort;
};

class IgtlServer : public ThreadedOutput {
 public:
  /// Listens, and starts. Throws Error for a wrong address or a port in use.
  IgtlServer(const std::string& name, const IgtlPlaceToListen& place, LiveContent content,
             LiveIncoming incoming = {});
  ~IgtlServer() override;
  /// Port that is listened to.
  int port() const { return port_; }

 private:
  void work() override;
  void finish(const LiveFrame& frame) override;
  void listen(const IgtlPlaceToListen& place);
  void accept();
  void serve(const LiveFrame& frame);
  void answer(IgtlPeer& peer, const IgtlMessage& request);
  void takeOrders(IgtlPeer& peer, const IgtlMessage& message);
  void answerGet(IgtlPeer& peer, const std::string& type, const std::string& device);
  void answerStart(IgtlPeer& peer, const std::string& type, const IgtlMessage& request, bool is_start);
  void sendContents();
  void dropGone();

  const LiveIncoming incoming_;
  int listening_ = -1, port_ = 0;
  std::shared_ptr<const LiveFrame> frame_;  // the newest one; null: none yet
  std::vector<std::shared_ptr<IgtlPeer>> peers_;
  std::vector<std::string> told_;  // clients in the report
  IgtlContentThread content_;
};

}  // namespace facenav::links
