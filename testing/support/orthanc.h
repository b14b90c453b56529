#pragma once
// A real archive for the tests: Orthanc (Debian package), started on loopback with free ports and its own
// storage in a temporary folder, stopped at the end.

#include <chrono>
#include <fstream>
#include <memory>
#include <string>
#include <thread>

#include "facenav/core/child_process.h"
#include "facenav/core/error.h"
#include "facenav/pacs/pacs.h"
#include "support/free_port.h"
#include "support/test_data.h"

namespace facenav::testing {

inline std::string orthancProgram() {
  for (const char* path : {"/usr/sbin/Orthanc", "/usr/bin/Orthanc"})
    if (std::filesystem::exists(path)) return path;
  return {};
}

class Orthanc {
 public:
  /// `more`: further lines of the configuration, each ending with a comma.
  explicit Orthanc(const std::string& more = "") {
    node_.port = freePort();
    node_.own_port = freePort();
    node_.title = "ORTHANC";
    node_.timeout_s = 20;
    const auto config = folder_.path() / "orthanc.json";
    std::ofstream(config)
        << "{" << more << "\"Name\": \"test\", \"HttpServerEnabled\": false, \"DicomAet\": \"ORTHANC\", "
        << "\"DicomCheckCalledAet\": true, \"DicomAlwaysAllowGet\": true, \"DicomPort\": " << node_.port
        << ", \"StorageDirectory\": \"" << (folder_.path() / "storage").string()
        << "\", \"IndexDirectory\": \"" << (folder_.path() / "storage").string()
        << "\", \"ConcurrentJobs\": 1, \"Plugins\": [], \"DicomModalities\": {\"us\": [\"FACENAV\", "
        << "\"127.0.0.1\", " << node_.own_port << "]}}";
    ChildOptions options;
    options.output = ChildOptions::Output::file;
    options.output_file = folder_.path() / "log";
    process_ =
        std::make_unique<ChildProcess>(ChildProcess::start({orthancProgram(), config.string()}, options));
  }
  ~Orthanc() { process_->end(); }

  const pacs::PacsNode& node() const { return node_; }
  /// Waits until it answers `node`; false if it does not within about 30 s.
  bool answers(const pacs::PacsNode& node) const {
    for (int i = 0; i < 300; ++i) try {
        pacs::echo(node);
        return true;
      } catch (const Error&) {
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
      }
    return false;
  }

 private:
  TemporaryFolder folder_;
  pacs::PacsNode node_;
  std::unique_ptr<ChildProcess> process_;
};

}  // namespace facenav::testing

#define FACENAV_NEEDS_ORTHANC() \
  if (facenav::testing::orthancProgram().empty()) GTEST_SKIP() << "Debian package orthanc is not installed"
