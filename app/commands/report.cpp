// facenav report CASE [SESSION]: a session as one page for the chart (HTML), as PDF, and as a DICOM object
// for the archive. The window's program prints the PDF, without a window, since this one has no Qt.

#include <cstdio>
#include <memory>

#include "commands/commands.h"
#include "facenav/casefile/kept_session.h"
#include "facenav/core/child_process.h"
#include "facenav/core/error.h"
#include "facenav/core/log.h"
#include "facenav/core/standard_output.h"
#include "facenav/core/whole_file.h"
#include "facenav/report/report_language.h"
#include "facenav/report/session_report.h"
#include "facenav/review/pulse_pictures.h"
#include "facenav/review/report_document.h"
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
  std::optional<fs::path> output, pdf, dicom;
  fs::path source;
  std::string language = "en";
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
  if (request.language != "en") command.insert(command.end(), {"--language", request.language});
  if (request.options.has_name) command.push_back("--with-name");
  if (request.has_no_pictures) command.push_back("--no-pictures");
  const auto end = ChildProcess::start(command).wait();
  if (!end.isDone()) throw Error("the PDF could not be written", pdf.string(), "see the line above");
}

/// Wraps the report's PDF for the archive. A PDF that nobody asked for is made beside the object and removed.
void writeDicom(const ReportRequest& request, const casefile::CaseStore& store,
                const fs::path& session_folder, const std::optional<fs::path>& made_pdf,
                const Context& context) {
  const WholeFile scratch(fs::path(*request.dicom).replace_extension(".pdf"));  // never committed
  if (!made_pdf) printPdf(request, session_folder, scratch.temporaryPath(), context);
  steps::writeReportDocument(store, session_folder, readWholeFile(made_pdf.value_or(scratch.temporaryPath())),
                             request.source, *request.dicom, context.monitor);
  if (!context.is_quiet) std::printf("%s: with the patient's name\n", request.dicom->c_str());
}

/// Refuses options that do not fit together.
void requireFittingOptions(const ReportRequest& request) {
  if (request.output && isStandardOutput(*request.output) && request.is_pdf_wanted)
    throw WrongUsage("--pdf writes beside the page, which goes to standard output", "give --pdf-file FILE");
  if (request.dicom && request.source.empty())
    throw WrongUsage(
        "the case holds no patient's name and study; they are in the files that it was prepared from",
        "give their folder with --source");
  if (!request.dicom && !request.source.empty())
    throw WrongUsage("--source does nothing here", "give it with --dicom");
  if (request.dicom && isStandardOutput(*request.dicom))
    throw WrongUsage("a DICOM object is not written to standard output", "name a file");
}

std::vector<std::string> languages() {
  auto codes = report::languageCodes();
  codes.insert(codes.begin(), "en");
  return codes;
}

void makeReport(const ReportRequest& request, const Context& context) {
  requireFittingOptions(request);
  auto options = request.options;
  options.language = report::languageOf(request.language);
  const auto store = casefile::CaseStore::open(request.case_folder);
  const auto folder = casefile::findSession(store.folder(), request.session);
  const auto session = casefile::readSession(folder);
  if (!context.is_quiet)
    for (const auto& problem : session.pulses.problems) std::fprintf(stderr, "note: %s\n", problem.c_str());
  const auto display = request.has_no_pictures ? nullptr : displayForPictures(context);
  if (!request.has_no_pictures) options.pictures = steps::pulsePictures(store, session);
  const auto page = request.output.value_or(folder / "report.html");
  writeWholeFile(page, report::sessionReport(store, session, options), FileAccess::owner_only);
  if (!context.is_quiet && !isStandardOutput(page)) std::printf("%s\n", page.c_str());
  std::optional<fs::path> pdf;
  if (request.is_pdf_wanted || request.pdf) {
    pdf = request.pdf.value_or(fs::path(page).replace_extension(".pdf"));
    printPdf(request, folder, *pdf, context);
    if (!context.is_quiet) std::printf("%s\n", pdf->c_str());
  }
  if (pdf && isStandardOutput(*pdf)) pdf.reset();  // it cannot be read back
  if (request.dicom) writeDicom(request, store, folder, pdf, context);
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
  verb->add_option(
          "--dicom", request->dicom,
          "also as a DICOM object (Encapsulated PDF) for the archive, into this file; needs --source; "
          "'facenav pacs store' sends it")
      ->check(namedLike({".dcm"}, "DICOM object"));
  verb->add_option(
      "--source", request->source,
      "of --dicom: folder of the DICOM files that the case was prepared from; patient and study are "
      "taken from there");
  verb->add_option("--language", request->language,
                   "language of the report's words; names and notes stay as they are")
      ->check(CLI::IsMember(languages()))
      ->capture_default_str();
  verb->add_flag("--no-pictures", request->has_no_pictures, "without pictures of the pulses on the cortex");
  verb->add_flag("--with-name", request->options.has_name, "adds the case's label (it may be a name)");
  verb->callback([&context, request] { makeReport(*request, context); });
}

}  // namespace facenav::app
