#include "facenav/casefile/session_log.h"

#include <fstream>
#include <nlohmann/json.hpp>
#include <vector>

#include "appended_file.h"
#include "csv_line.h"
#include "facenav/core/error.h"
#include "facenav/core/settings_in_force.h"
#include "facenav/core/whole_folder.h"
#include "utc_now.h"

namespace facenav::casefile {
namespace fs = std::filesystem;
namespace {

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

/// One table of a session. A table begun by an older version keeps its own columns.
class AppendedTable {
 public:
  AppendedTable(const fs::path& path, const std::string& header, AppendedFile::Start start)
      : file_(path, header, start), order_(header, headerOf(path)) {}
  void append(const std::string& line) { file_.append(order_.inOrder(line)); }
  void sync() { file_.sync(); }
  AppendedFile& file() { return file_; }

 private:
  static std::string headerOf(const fs::path& path) {
    std::ifstream stream(path);
    std::string header;
    if (!std::getline(stream, header) || !columnOf(header, "frame") || !columnOf(header, "t_s"))
      throw Error("its first line names no columns frame and t_s", path.string(),
                  "begin a new session, or put the line back");
    return header;
  }
  AppendedFile file_;
  ColumnOrder order_;
};

}  // namespace

struct SessionLog::Implementation {
  Implementation(fs::path session_folder, AppendedFile::Start start)
      : folder(std::move(session_folder)),
        events(folder / "events.jsonl", "", start),
        poses(folder / "poses.csv", posesCsvHeader(), start),
        guidance(folder / "guidance.csv", guidance::guidanceCsvHeader(), start) {
    events.lock();
  }
  fs::path folder;
  AppendedFile events;
  AppendedTable poses, guidance;
  // These belong to a second coil. Null: it has no line yet.
  std::unique_ptr<AppendedTable> second_poses, second_guidance;

  AppendedTable& second(std::unique_ptr<AppendedTable>& table, const char* first, const std::string& header) {
    if (!table)
      table = std::make_unique<AppendedTable>(secondCoilPath(folder / first), secondCoilHeader(header),
                                              AppendedFile::Start::old_or_fresh);
    return *table;
  }
  std::vector<AppendedTable*> tables() {
    std::vector<AppendedTable*> all{&poses, &guidance};
    for (const auto& table : {second_poses.get(), second_guidance.get()})
      if (table) all.push_back(table);
    return all;
  }
};

SessionLog::SessionLog(const fs::path& case_folder)
    : SessionLog(
          std::make_unique<Implementation>(makeSessionFolder(case_folder), AppendedFile::Start::fresh)) {}

SessionLog SessionLog::goOn(const fs::path& session_folder) {
  if (!fs::exists(session_folder / "events.jsonl"))
    throw Error("this is no session", session_folder.string(), "choose one of the case's sessions");
  return SessionLog(std::make_unique<Implementation>(session_folder, AppendedFile::Start::old_or_fresh));
}

SessionLog::SessionLog(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {
  for (const std::string& setting : changedSettingsInWords()) addEvent("changed_setting", setting);
}
SessionLog::~SessionLog() = default;
SessionLog::SessionLog(SessionLog&&) noexcept = default;
SessionLog& SessionLog::operator=(SessionLog&&) noexcept = default;

const fs::path& SessionLog::folder() const { return implementation_->folder; }
void SessionLog::add(const PoseRow& row) { implementation_->poses.append(toCsvLine(row)); }
void SessionLog::add(const guidance::GuidanceRow& row) { implementation_->guidance.append(toCsvLine(row)); }

void SessionLog::addSecond(const PoseRow& row, const std::string& coil) {
  auto& i = *implementation_;
  i.second(i.second_poses, "poses.csv", posesCsvHeader()).append(ofSecondCoil(toCsvLine(row), coil));
}

void SessionLog::addSecond(const guidance::GuidanceRow& row, const std::string& coil) {
  auto& i = *implementation_;
  i.second(i.second_guidance, "guidance.csv", guidance::guidanceCsvHeader())
      .append(ofSecondCoil(toCsvLine(row), coil));
}

bool SessionLog::putBack() {
  auto& i = *implementation_;
  bool was_removed = false;
  std::vector<AppendedFile*> files{&i.events};
  for (auto* table : i.tables()) files.push_back(&table->file());
  for (AppendedFile* file : files) {
    was_removed |= file->isRemoved();
    file->putBack();
  }
  return was_removed;
}

void SessionLog::addEvent(const std::string& event, const std::string& detail) {
  const nlohmann::ordered_json line{{"utc", utcNow()}, {"event", event}, {"detail", detail}};
  implementation_->events.append(line.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
  implementation_->events.sync();
}

void SessionLog::sync() {
  for (auto* table : implementation_->tables()) table->sync();
  implementation_->events.sync();
}

}  // namespace facenav::casefile
