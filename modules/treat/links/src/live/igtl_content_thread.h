#pragma once
// IgtlContentThread: makes what clients ask for and what takes long (the MRI, surfaces) beside the server's
// own thread. Finished content is kept, because it does not change while the server runs.

#include <condition_variable>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <thread>

#include "facenav/links/igtl_message.h"
#include "facenav/links/live_output.h"

namespace facenav::links {

class IgtlPeer;

/// An order of a client, and the whole message once it is made.
struct IgtlOrder {
  std::weak_ptr<IgtlPeer> peer;
  std::string type, name;
  int header_version = 1;
  std::shared_ptr<const Bytes> message = nullptr;  // null: there is no such content
};

class IgtlContentThread {
 public:
  /// `done` is called on its thread after each order.
  IgtlContentThread(LiveContent content, std::function<void()> done);
  ~IgtlContentThread();
  /// Returns false if too many orders wait.
  bool order(IgtlOrder order);
  /// Takes the orders that are made.
  std::deque<IgtlOrder> takeMade();
  /// Waits for the order in work and ends the thread.
  void stop();

 private:
  void run();
  std::shared_ptr<const Bytes> make(const IgtlOrder& order);

  LiveContent content_;
  std::function<void()> done_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<IgtlOrder> orders_, made_;
  bool is_stopping_ = false;
  std::map<std::string, std::shared_ptr<const Bytes>> kept_;  // of the thread
  std::thread thread_;
};

}  // namespace facenav::links
