#pragma once
// Our own storage SCP, active during one C-MOVE. It listens on a port, accepts images for our title only, and
// writes them exactly as sent under its own file names.

#include <atomic>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "facenav/pacs/pacs.h"

namespace facenav::pacs {

class StorageProvider {
 public:
  /// Starts to listen; accepts images in `syntaxes`, the first ones preferred. Throws Error if the port is in
  /// use.
  StorageProvider(const PacsNode& node, const std::filesystem::path& folder,
                  const std::vector<std::string>& syntaxes);
  /// Stops listening and waits for a running transfer.
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
