#include "facenav/casefile/session_log.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>

#include "facenav/core/error.h"
#include "facenav/core/whole_folder.h"
#include "utc_now.h"

namespace facenav::casefile {
namespace fs = std::filesystem;
namespace {

/// A file to append to. Each line is written in one call, so that a crash leaves only whole lines.
class AppendedFile {
 public:
  AppendedFile(fs::path path, const std::string& header) : path_(std::move(path)) {
    descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0600);
    if (descriptor_ < 0) refuse();
    append(header);
  }
  ~AppendedFile() {
    ::fsync(descriptor_);
    ::close(descriptor_);
  }
  AppendedFile(const AppendedFile&) = delete;
  AppendedFile& operator=(const AppendedFile&) = delete;

  void append(const std::string& line) {
    for (std::size_t done = 0; done < line.size();) {
      const ssize_t written = ::write(descriptor_, line.data() + done, line.size() - done);
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) refuse();
      done += std::size_t(written);
    }
  }
  void sync() {
    if (::fsync(descriptor_) != 0) refuse();
  }

 private:
  [[noreturn]] void refuse() const {
    throw Error(std::string("cannot be written (") + std::strerror(errno) + ")", path_.string(),
                "check free disk space and permissions");
  }
  fs::path path_;
  int descriptor_ = -1;
};

fs::path makeSessionFolder(const fs::path& case_folder) {
  if (!fs::is_directory(case_folder))
    throw Error("folder does not exist", case_folder.string(), "open a case first");
  const fs::path sessions = case_folder / "sessions";
  if (!fs::exists(sessions)) makePrivateFolder(sessions);
  const std::string time = utcNow();
  fs::path folder = sessions / time;
  for (int count = 2; fs::exists(folder); ++count) folder = sessions / (time + "_" + std::to_string(count));
  makePrivateFolder(folder);
  return folder;
}

}  // namespace

struct SessionLog::Implementation {
  explicit Implementation(const fs::path& case_folder)
      : folder(makeSessionFolder(case_folder)),
        poses(folder / "poses.csv", posesCsvHeader()),
        guidance(folder / "guidance.csv", guidance::guidanceCsvHeader()),
        events(folder / "events.jsonl", "") {}
  fs::path folder;
  AppendedFile poses, guidance, events;
};

SessionLog::SessionLog(const fs::path& case_folder)
    : implementation_(std::make_unique<Implementation>(case_folder)) {}
SessionLog::~SessionLog() = default;
SessionLog::SessionLog(SessionLog&&) noexcept = default;
SessionLog& SessionLog::operator=(SessionLog&&) noexcept = default;

const fs::path& SessionLog::folder() const { return implementation_->folder; }
void SessionLog::add(const PoseRow& row) { implementation_->poses.append(toCsvLine(row)); }
void SessionLog::add(const guidance::GuidanceRow& row) { implementation_->guidance.append(toCsvLine(row)); }

void SessionLog::addEvent(const std::string& event, const std::string& detail) {
  const nlohmann::ordered_json line{{"utc", utcNow()}, {"event", event}, {"detail", detail}};
  implementation_->events.append(line.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
  implementation_->events.sync();
}

void SessionLog::sync() {
  implementation_->poses.sync();
  implementation_->guidance.sync();
  implementation_->events.sync();
}

}  // namespace facenav::casefile
