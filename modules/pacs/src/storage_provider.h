#pragma once
// Our own storage SCP for the time of one C-MOVE: listens on a port, takes images for our title alone, writes
// them exactly as sent under names of its own.

#include <atomic>
#include <filesystem>
#include <memory>
#include <thread>

#include "facenav/pacs/pacs.h"

namespace facenav::pacs {

class StorageProvider {
 public:
  /// Listens at once. Throws Error when the port is taken.
  StorageProvider(const PacsNode& node, const std::filesystem::path& folder);
  /// Stops listening and waits for the running transfer, if any.
  ~StorageProvider();
  StorageProvider(const StorageProvider&) = delete;
  StorageProvider& operator=(const StorageProvider&) = delete;

  int images() const;

 private:
  struct Listener;
  std::unique_ptr<Listener> listener_;
  std::thread thread_;
};

}  // namespace facenav::pacs
