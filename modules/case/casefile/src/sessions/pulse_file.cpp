#include "facenav/casefile/pulse_file.h"

#include "appended_file.h"
#include "facenav/core/error.h"
#include "facenav/core/whole_folder.h"

namespace facenav::casefile {
namespace fs = std::filesystem;
namespace {

constexpr const char* kName = "pulses.jsonl";

/// Syncs the folders up to the case folder, because a file is durable only if its name is.
void syncNames(const fs::path& session_folder) {
  makeNamesDurable(session_folder);
  makeNamesDurable(session_folder.parent_path());
  makeNamesDurable(session_folder.parent_path().parent_path());
}

}  // namespace

struct PulseFile::Implementation {
  fs::path folder;
  std::unique_ptr<AppendedFile> file;

  void open(AppendedFile::Start start) {
    file = std::make_unique<AppendedFile>(folder / kName, "", start);
    syncNames(folder);
  }
  /// Makes the removed file again under its name, with all its content.
  void makeAgain() {
    file->putBack();
    syncNames(folder);
  }
};

PulseFile::PulseFile(const fs::path& session_folder, Begin begin)
    : implementation_(std::make_unique<Implementation>()) {
  implementation_->folder = session_folder;
  implementation_->open(begin == Begin::fresh ? AppendedFile::Start::fresh
                                              : AppendedFile::Start::old_or_fresh);
}

PulseFile::~PulseFile() = default;

void PulseFile::keep(const Pulse& pulse) {
  if (implementation_->file->isRemoved()) implementation_->makeAgain();
  AppendedFile& file = *implementation_->file;
  file.append(toJsonLine(pulse));
  try {
    file.sync();
  } catch (const Error&) {
    file.undoLast();
    throw;
  }
}

}  // namespace facenav::casefile
