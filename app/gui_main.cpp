// facenav-gui: the workstation window, with the methods of app/registrations.h.

#include <sys/stat.h>

#include <CLI/CLI.hpp>
#include <QApplication>
#include <QFile>
#include <QGuiApplication>
#include <QSettings>
#include <QTimer>
#include <cstdio>
#include <memory>

#include "facenav/core/error.h"
#include "facenav/core/parallel_for.h"
#include "facenav/core/settings_in_force.h"
#include "facenav/report/report_language.h"
#include "facenav/review/pulse_pictures.h"
#include "facenav/scene/display.h"
#include "home/home_window.h"
#include "opened_path.h"
#include "prepare/prepare_workspace.h"
#include "prepare/worklist_presenter.h"
#include "registrations.h"
#include "settings_flags.h"
#include "setup/setup_window.h"
#include "shell/appearance.h"
#include "shell/language.h"
#include "shell/main_window.h"
#include "shell/report_pdf.h"
#include "shell/screenshot.h"
#include "shell/theme.h"
#include "shell/work_area.h"
#include "software_commit.h"
#include "wrong_usage.h"

namespace {

using namespace facenav;

struct Arguments {
  app::SettingsRequest settings;
  std::string case_folder, cases_folder, recording, workspace, step, screenshot, by, override_reason;
  std::string language = "en", report_pdf, session, home, rig, opened, theme;
  bool then_guides = false, has_name = false, has_no_pictures = false, is_set_up = false;
  double after_s = 3.0, text_scale = 0.0;  // 0: as last time
};

ui::PrepareStep stepNamed(const std::string& name) {
  if (name == "series") return ui::PrepareStep::series;
  if (name == "check") return ui::PrepareStep::check;
  return name == "sign-off" ? ui::PrepareStep::sign_off : ui::PrepareStep::worklist;
}

/// Saves a picture of the window and quits.
void saveScreenshot(QWidget& window, const std::string& path) {
  try {
    ui::writeScreenshot(window, QString::fromStdString(path));
    QApplication::exit(0);
  } catch (const Error& error) {
    std::fprintf(stderr, "facenav-gui: the screenshot could not be written: %s\n", error.what());
    QApplication::exit(1);
  }
}

/// Starts the wait when the window shows what the command line asked for.
void takeScreenshotLater(ui::MainWindow& window, const Arguments& arguments) {
  auto* poll = new QTimer(&window);
  QObject::connect(poll, &QTimer::timeout, &window, [&window, arguments, poll] {
    if (!window.isSettled()) return;
    poll->stop();
    QTimer::singleShot(int(arguments.after_s * 1000), &window,
                       [&window, arguments] { saveScreenshot(window, arguments.screenshot); });
  });
  poll->start(30);
}

/// Opens the case at the given step, by default at Check.
void openWhatIsAsked(ui::MainWindow& window, const Arguments& arguments) {
  if (!arguments.case_folder.empty())
    return window.openCaseAt(QString::fromStdString(arguments.case_folder),
                             stepNamed(arguments.step.empty() ? "check" : arguments.step));
  if (!arguments.step.empty()) window.setPrepareStep(stepNamed(arguments.step));
}

/// Makes the settings readable only by this user: they contain the queue's paths, which may contain a
/// patient's name.
void keepFilesPrivate() {
  ::umask(077);
  const QString settings = QSettings().fileName();
  if (QFile::exists(settings)) QFile::setPermissions(settings, QFile::ReadOwner | QFile::WriteOwner);
}

/// Prints the report of a session as PDF, without a window. With an X display the report has pictures.
int printReport(int argc, char** argv, const Arguments& arguments) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  QGuiApplication application(argc, argv);
  const auto store = casefile::CaseStore::open(arguments.case_folder);
  const auto session = casefile::readSession(casefile::findSession(store.folder(), arguments.session));
  report::ReportOptions options;
  options.has_name = arguments.has_name;
  options.language = report::languageOf(arguments.language);
  if (!arguments.has_no_pictures) options.pictures = steps::pulsePictures(store, session);
  ui::writeReportPdf(report::makeSessionReport(store, session, options), arguments.report_pdf);
  return 0;
}

/// Runs the three steps for a person at home or a nurse. Files stay private: they show a face.
int runHome(QApplication& application, const Arguments& arguments) {
  ui::HomeWindow window(ui::servicesWith(app::makeRegistrations));
  window.presenter().open(QString::fromStdString(arguments.home));
  if (!arguments.recording.empty()) window.presenter().play(QString::fromStdString(arguments.recording));
  auto has_begun = std::make_shared<bool>(arguments.recording.empty());
  QObject::connect(&window.presenter(), &ui::HomePresenter::changed, &window, [&window, has_begun] {
    if (*has_begun || window.presenter().stage() != ui::HomePresenter::Stage::sit) return;
    *has_begun = true;  // a recording starts by itself, as in the other window
    QTimer::singleShot(0, &window, [&window] { window.presenter().act(); });
  });
  ui::fitIntoWorkArea(window, {1366, 768});
  window.show();
  if (!arguments.screenshot.empty())
    QTimer::singleShot(int(arguments.after_s * 1000), &window,
                       [&window, arguments] { saveScreenshot(window, arguments.screenshot); });
  return application.exec();
}

/// Runs only the set-up of a camera pair.
int runSetUp(QApplication& application, const Arguments& arguments) {
  ui::SetupWindow window(ui::servicesWith(app::makeRegistrations));
  ui::fitIntoWorkArea(window, {1366, 768});
  window.show();
  if (!arguments.rig.empty()) window.openKept(QString::fromStdString(arguments.rig));
  if (!arguments.screenshot.empty())
    QTimer::singleShot(int(arguments.after_s * 1000), &window,
                       [&window, arguments] { saveScreenshot(window, arguments.screenshot); });
  return application.exec();
}

int runWindow(int argc, char** argv, const Arguments& arguments) {
  if (!scene::hasDisplay()) {
    std::fprintf(stderr, "facenav-gui: no X display (DISPLAY): start it on a desktop, or under xvfb-run\n");
    return 1;
  }
  if (const std::string problem = scene::openGlProblem(); !problem.empty())
    throw Error(problem, {}, "start it on the computer itself, or under xvfb-run");
  ui::prepareSurfaceFormat();
  QApplication application(argc, argv);
  QApplication::setOrganizationName("FaceNav");
  QApplication::setApplicationName("FaceNav");
  QApplication::setApplicationVersion(QString::fromStdString(app::versionInWords()));
  keepFilesPrivate();
  if (arguments.text_scale > 0) ui::rememberTextScale(arguments.text_scale);
  if (!arguments.theme.empty())
    ui::rememberTheme(ui::themeChoiceNamed(QString::fromStdString(arguments.theme)));
  ui::useTheme(ui::rememberedTheme());
  ui::applyLanguage(application, ui::wantedLanguage());
  ui::applyAppearance(application, ui::rememberedTextScale());
  // Starts the shared threads now, at the window's own priority.
  runOnWorkers(coreCount(), [](std::size_t) {});
  if (!arguments.home.empty()) return runHome(application, arguments);
  if (arguments.is_set_up) return runSetUp(application, arguments);
  ui::MainWindow window(ui::servicesWith(app::makeRegistrations));
  if (!changedSettings().empty()) window.setWindowTitle(QObject::tr("FaceNav (changed settings)"));
  if (arguments.case_folder.empty() && arguments.recording.empty() && arguments.screenshot.empty())
    window.restoreLast();
  window.setCasesFolder(arguments.cases_folder.empty() ? ui::WorklistPresenter::rememberedFolder()
                                                       : QString::fromStdString(arguments.cases_folder));
  if (!arguments.override_reason.empty())
    window.overrideSignOff(QString::fromStdString(arguments.by),
                           QString::fromStdString(arguments.override_reason));
  openWhatIsAsked(window, arguments);
  if (!arguments.recording.empty())
    window.play(QString::fromStdString(arguments.recording), arguments.then_guides);
  if (arguments.workspace == "plan") window.setWorkspace(ui::Workspace::plan);
  if (arguments.workspace == "review") window.setWorkspace(ui::Workspace::review);
  if (arguments.workspace == "treat" || (arguments.workspace.empty() && !arguments.recording.empty()))
    window.setWorkspace(ui::Workspace::treat);
  window.show();
  if (!arguments.screenshot.empty()) takeScreenshotLater(window, arguments);
  return QApplication::exec();
}

/// Opens what the desktop gave as if it had been named by its option.
void takeOpened(Arguments& arguments) {
  if (arguments.opened.empty()) return;
  const app::OpenedPath opened = app::openedPath(arguments.opened);
  const auto take = [](std::string& option, const std::filesystem::path& path) {
    if (!path.empty()) option = path.string();
  };
  take(arguments.case_folder, opened.case_folder);
  take(arguments.recording, opened.recording);
  take(arguments.home, opened.home);
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  CLI::App cli("FaceNav: the workstation window", "facenav-gui");
  auto* path = cli.add_option("PATH", arguments.opened,
                              "a case's folder or its case.json, or a recording's folder or its stereo.yml");
  cli.add_option("--case", arguments.case_folder, "case folder to open")->excludes(path);
  cli.add_option(
      "--home", arguments.home,
      "case for use near home ('facenav import'): three steps, big buttons, one file to send back");
  auto* set_up = cli.add_flag("--set-up", arguments.is_set_up,
                              "places, calibrates and checks two cameras and the coil in four steps");
  cli.add_option("--rig", arguments.rig, "with --set-up: a pair that is kept, to check or repair it")
      ->needs(set_up);
  cli.add_option("--cases", arguments.cases_folder, "folder of cases that the worklist shows; remembered");
  cli.add_option("--step", arguments.step, "of prepare: worklist, series, check or sign-off")
      ->check(CLI::IsMember({"worklist", "series", "check", "sign-off"}));
  auto* reason = cli.add_option("--override", arguments.override_reason,
                                "treat the case without a sign-off for this reason; recorded in the case");
  auto* by = cli.add_option("--by", arguments.by, "who overrides");
  reason->needs(by);
  auto* play = cli.add_option("--play", arguments.recording, "recording to align with, to play it live");
  cli.add_flag("--guide", arguments.then_guides, "with --play: start guiding at once")->needs(play);
  cli.add_option("--workspace", arguments.workspace, "prepare, plan, treat or review")
      ->check(CLI::IsMember({"prepare", "plan", "treat", "review"}));
  cli.add_option("--screenshot", arguments.screenshot, "save a picture of the window (PNG) and quit");
  cli.add_option("--after", arguments.after_s,
                 "seconds to wait before the screenshot, from when case and recording are shown")
      ->check(CLI::Range(0.1, 600.0));
  cli.add_option("--text-scale", arguments.text_scale, "all text larger or smaller, 2: twice; remembered")
      ->check(CLI::Range(ui::kLeastTextScale, ui::kMostTextScale));
  cli.add_option("--theme", arguments.theme, "dark, light, or system: as the desktop's colours; remembered")
      ->check(CLI::IsMember({"dark", "light", "system"}));
  cli.add_option("--report-pdf", arguments.report_pdf,
                 "write the report of a session of --case as PDF and quit, without a window");
  cli.add_option("--session", arguments.session, "for --report-pdf: its name; default: the newest");
  cli.add_flag("--no-pictures", arguments.has_no_pictures,
               "for --report-pdf: without pictures of the pulses on the cortex");
  cli.add_flag("--with-name", arguments.has_name, "for --report-pdf: adds the case's label");
  cli.add_option("--language", arguments.language, "for --report-pdf: its language, en or ja");
  app::addSettingsFlags(cli, arguments.settings);
  try {
    cli.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return cli.exit(error) == 0 ? 0 : 2;
  }
  try {
    takeOpened(arguments);
    app::useSettings(arguments.settings);
    if (!arguments.report_pdf.empty()) return printReport(argc, argv, arguments);
    return runWindow(argc, argv, arguments);
  } catch (const app::WrongUsage& error) {
    std::fprintf(stderr, "facenav-gui: %s\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "facenav-gui: %s\n", error.what());
    return 1;
  }
}
