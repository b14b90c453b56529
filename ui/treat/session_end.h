#pragma once
// The end of a session beside the window: its cameras, its log and its report take their own time, and the
// window does not wait for them.

#include <filesystem>
#include <functional>
#include <memory>

#include "facenav/treat/treatment.h"
#include "shell/asynchronous_shutdown.h"

namespace facenav::ui {

/// A good camera ends within one frame, the log when all is written; the report follows. Returns then, or
/// after a second.
void endBeside(AsynchronousShutdown& retirement, std::shared_ptr<steps::Treatment> treatment);
/// The same in two steps: `report` comes after `end`, also where `end` throws.
void endBeside(AsynchronousShutdown& retirement, std::function<void()> end, std::function<void()> report);
/// Writes the report of a session that has ended again.
void reportBeside(AsynchronousShutdown& retirement, const std::filesystem::path& case_folder,
                  const std::filesystem::path& session);

}  // namespace facenav::ui
