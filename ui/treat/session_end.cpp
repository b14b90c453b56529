#include "treat/session_end.h"

#include <future>

#include "facenav/report/session_report.h"
#include "shell/shown_words.h"

namespace facenav::ui {
namespace {

constexpr std::chrono::milliseconds kPatience(1000);  // time for a session to end

report::ReportOptions inWindowsLanguage() {
  report::ReportOptions options;
  options.language = reportLanguage();
  return options;
}

}  // namespace

void endBeside(AsynchronousShutdown& retirement, std::shared_ptr<steps::Treatment> treatment,
               const std::string& why, std::function<void()> then) {
  endBeside(
      retirement, [treatment, why] { treatment->end(why); },
      [treatment, then = std::move(then)] {
        treatment->keepReport(inWindowsLanguage());
        if (then) then();
      });
}

void endBeside(AsynchronousShutdown& retirement, std::function<void()> end, std::function<void()> report) {
  auto has_ended = std::make_shared<std::promise<void>>();
  retirement.add(
      [report = std::move(report), ended = has_ended->get_future().share()] {
        ended.wait();
        report();
      },
      std::chrono::milliseconds(0));
  retirement.add(
      [end = std::move(end), has_ended] {
        try {
          end();
        } catch (...) {
          has_ended->set_value();  // the report waits for the session's end, and the window for the report
          throw;
        }
        has_ended->set_value();
      },
      kPatience);
}

void reportBeside(AsynchronousShutdown& retirement, const std::filesystem::path& case_folder,
                  const std::filesystem::path& session) {
  retirement.add(
      [case_folder, session] { report::writeSessionReport(case_folder, session, inWindowsLanguage()); },
      std::chrono::milliseconds(0));
}

}  // namespace facenav::ui
