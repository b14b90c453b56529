#pragma once
// Ends a session in the background: its cameras, log and report take time, and the window does not wait for
// them.

#include <filesystem>
#include <functional>
#include <memory>

#include "facenav/treat/treatment.h"
#include "shell/asynchronous_shutdown.h"

namespace facenav::ui {

/// Ends the treatment, then writes its report. Returns when the cameras have ended (normally within one
/// frame) and the log is written, or after a second. `why`: as Treatment::end(). `then`: called after the
/// report, on its thread; may be empty.
void endBeside(AsynchronousShutdown& retirement, std::shared_ptr<steps::Treatment> treatment,
               const std::string& why = {}, std::function<void()> then = {});
/// Ends in two steps: `report` follows `end`, also if `end` throws.
void endBeside(AsynchronousShutdown& retirement, std::function<void()> end, std::function<void()> report);
/// Writes the report of an ended session again.
void reportBeside(AsynchronousShutdown& retirement, const std::filesystem::path& case_folder,
                  const std::filesystem::path& session);

}  // namespace facenav::ui
