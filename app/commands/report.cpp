// facenav report CASE [SESSION]: a session as one page for the chart (HTML), and as PDF. The window's program
// prints the PDF, without a window, since this one has no Qt.

#include <cstdio>
#include <memory>

#include "commands/commands.h"
#include "facenav/casefile/kept_session.h"
#include "facenav/core/child_process.h"
#include "facenav/core/error.h"
#include "facenav/core/log.h"
#include "facenav/core/standard_output.h"
#include "facenav/core/whole_file.h"
#include "facenav/report/session_report.h"
#include "facenav/review/pulse_pictures.h"
#include "facenav/scene/display.h"
#include "typed_values.h"
#include "virtual_display.h"
#include "wrong_usage.h"

namespace facenav::app {
namespace fs = std::filesystem;
namespace {

struct ReportRequest {
  fs::path case_folder;
  std::string session;
  std::optional<fs::path> output, pdf;
  bool is_pdf_wanted = false, has_no_pictures = false;
  report::ReportOptions options;
};

/// Starts a private display if there is none. Returns nothing if that fails; the report then has no pictures.
std::unique_ptr<VirtualDisplay> displayForPictures(const Context& context) {
  if (scene::canDrawScenes()) return nullptr;
  try {
    return std::make_unique<VirtualDisplay>();
  } catch (const Error& error) {
    if (!context.is_quiet) std::fprintf(stderr, "note: the report has no pictures: %s\n", error.what());
    return nullptr;
  }
}

void printPdf(const ReportRequest& request, const fs::path& session_folder, const fs::path& pdf,
              const Context& context) {
  const fs::path window = context.program.parent_path() / "facenav-gui";
  if (!fs::exists(window))
    throw Error("the PDF needs the window's program, which is not installed", window.string(),
                "print report.html from a browser");
  std::vector<std::string> command{window.string(),
                                   "--case",
                                   request.case_folder.string(),
                                   "--session",
                                   session_folder.filename().string(),
                                   "--report-pdf",
                                   pdf.string()};
  if (request.options.has_name) command.push_back("--with-name");
  if (request.has_no_pictures) command.push_back("--no-pictures");
  const auto end = ChildProcess::start(command).wait();
  if (!end.isDone()) throw Error("the PDF could not be written", pdf.string(), "see the line above");
}

void makeReport(const ReportRequest& request, const Context& context) {
  if (request.output && isStandardOutput(*request.output) && request.is_pdf_wanted)
    throw WrongUsage("--pdf writes beside the page, which goes to standard output", "give --pdf-file FILE");
  const auto store = casefile::CaseStore::open(request.case_folder);
  const auto folder = casefile::findSession(store.folder(), request.session);
  const auto session = casefile::readSession(folder);
  if (!context.is_quiet)
    for (const auto& problem : session.pulses.problems) std::fprintf(stderr, "note: %s\n", problem.c_str());
  const auto display = request.has_no_pictures ? nullptr : displayForPictures(context);
  auto options = request.options;
  if (!request.has_no_pictures) options.pictures = steps::pulsePictures(store, session);
  const auto page = request.output.value_or(folder / "report.html");
  writeWholeFile(page, report::sessionReport(store, session, options), FileAccess::owner_only);
  if (!context.is_quiet && !isStandardOutput(page)) std::printf("%s\n", page.c_str());
  if (!request.is_pdf_wanted && !request.pdf) return;
  const auto pdf = request.pdf.value_or(fs::path(page).replace_extension(".pdf"));
  printPdf(request, folder, pdf, context);
  if (!context.is_quiet) std::printf("%s\n", pdf.c_str());
}

}  // namespace

void addReport(CLI::App& app, Context& context) {
  auto* verb = app.add_subcommand("report", "a session as one page for the chart, to read and to print");
  auto request = std::make_shared<ReportRequest>();
  verb->add_option("CASE", request->case_folder, "case folder")->required();
  verb->add_option("SESSION", request->session, "its name, or how it begins; default: the newest");
  verb->add_option("-o,--output", request->output, "report.html to write; default: in the session's folder")
      ->check(namedLike({".html", ".htm"}, "report"));
  verb->add_flag("--pdf", request->is_pdf_wanted, "also as PDF, beside it");
  verb->add_option("--pdf-file", request->pdf, "also as PDF, into this file")
      ->check(namedLike({".pdf"}, "PDF"));
  verb->add_flag("--no-pictures", request->has_no_pictures, "without pictures of the pulses on the cortex");
  verb->add_flag("--with-name", request->options.has_name, "adds the case's label (it may be a name)");
  verb->callback([&context, request] { makeReport(*request, context); });
}

}  // namespace facenav::app
