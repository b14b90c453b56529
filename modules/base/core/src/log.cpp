#include "facenav/core/log.h"

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <mutex>
#include <set>

#include "facenav/core/shown_address.h"

namespace facenav {
inline namespace core {
namespace {

spdlog::logger& logger() {
  static const auto instance = [] {
    auto created = spdlog::stderr_color_mt("facenav");
    created->set_pattern("%^%l%$: %v");
    return created;
  }();
  return *instance;
}

}  // namespace

void logInfo(const std::string& message) { logger().info(shownAddress(message)); }
void logWarning(const std::string& message) { logger().warn(shownAddress(message)); }
void logWarningOnce(const std::string& message) {
  static std::mutex mutex;
  static std::set<std::string> told;
  const std::lock_guard<std::mutex> lock(mutex);
  if (told.insert(message).second) logWarning(message);
}
void setLogQuiet(bool is_quiet) { logger().set_level(is_quiet ? spdlog::level::warn : spdlog::level::info); }

}  // namespace core
}  // namespace facenav
