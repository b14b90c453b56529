#include "igtl_content_thread.h"

#include <utility>

#include "facenav/core/log.h"

namespace facenav::links {
namespace {

constexpr std::size_t kMostOrders = 16;

}  // namespace

IgtlContentThread::IgtlContentThread(LiveContent content, std::function<void()> done)
    : content_(std::move(content)), done_(std::move(done)), thread_([this] { run(); }) {}

IgtlContentThread::~IgtlContentThread() { stop(); }

void IgtlContentThread::stop() {
  {
    std::lock_guard lock(mutex_);
    is_stopping_ = true;
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
}

bool IgtlContentThread::order(IgtlOrder order) {
  {
    std::lock_guard lock(mutex_);
    if (orders_.size() >= kMostOrders) return false;
    orders_.push_back(std::move(order));
  }
  changed_.notify_all();
  return true;
}

std::deque<IgtlOrder> IgtlContentThread::takeMade() {
  std::lock_guard lock(mutex_);
  return std::exchange(made_, {});
}

std::shared_ptr<const Bytes> IgtlContentThread::make(const IgtlOrder& order) {
  const std::string key = order.type + '\n' + order.name + '\n' + std::to_string(order.header_version);
  const auto found = kept_.find(key);
  if (found != kept_.end()) return found->second;
  try {
    auto content = content_ ? content_(order.type, order.name) : std::nullopt;
    if (!content) return nullptr;
    IgtlMessage message;
    message.header_version = order.header_version;
    message.type = order.type;
    message.device = order.name;
    message.stamp = igtlStamp(std::chrono::system_clock::now());
    message.content = std::move(*content);
    auto whole = std::make_shared<const Bytes>(encoded(message));
    if (order.type != "POINT") kept_[key] = whole;  // targets change while a session runs
    return whole;
  } catch (const std::exception& error) {  // told to the client as "not found"
    logWarning(order.type + " " + order.name + " was asked for and cannot be sent: " + error.what());
    return nullptr;
  }
}

void IgtlContentThread::run() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return is_stopping_ || !orders_.empty(); });
    if (is_stopping_) return;
    IgtlOrder order = std::move(orders_.front());
    orders_.pop_front();
    lock.unlock();
    order.message = make(order);
    lock.lock();
    made_.push_back(std::move(order));
    lock.unlock();
    done_();
    lock.lock();
  }
}

}  // namespace facenav::links
