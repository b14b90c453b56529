// facenav demo [-o DIR]: the whole path on the virtual patient, ending in pictures, figures and report.

#include <unistd.h>

#include <cstdio>

#include "commands/lab_commands.h"
#include "demo/demo_run.h"
#include "demo/virtual_patient_files.h"
#include "facenav/scene/display.h"
#include "typed_values.h"

namespace facenav::app {
namespace {

void playInWindow(const Context& context, const std::filesystem::path& folder) {
  const auto window = context.program.parent_path() / "facenav-gui";
  if (!std::filesystem::exists(window)) return;
  std::printf("opening the window\n");
  std::fflush(stdout);
  ::execl(window.c_str(), window.c_str(), "--case", (folder / "case").c_str(), "--play",
          (folder / "recording").c_str(), "--by", "facenav demo", "--override", "virtual patient", nullptr);
}

}  // namespace

void addDemo(CLI::App& app, Context& context) {
  auto* verb =
      app.add_subcommand("demo", "the whole path on the virtual patient: model, align, track, guide, report");
  auto request = std::make_shared<DemoRequest>();
  auto stays_closed = std::make_shared<bool>(false);
  auto only_patient = std::make_shared<bool>(false);
  request->folder = "facenav_demo";
  verb->add_option("-o,--output", request->folder, "folder for the result")
      ->check(folderToMake())
      ->capture_default_str();
  verb->add_option("--seed", request->seed, "of the room's motion and noise")->capture_default_str();
  verb->add_option("--frames", request->frames, "length of the treatment (0: the scenario's own)")
      ->check(CLI::Range(0, 100000));
  verb->add_flag("--no-window", *stays_closed, "do not open the window at the end");
  verb->add_flag("--only-patient", *only_patient,
                 "convert the virtual patient's MRI into the cache and stop");
  verb->callback([&context, request, stays_closed, only_patient] {
    if (*only_patient) {
      virtualPatientFiles(context);
      return;
    }
    const bool has_display = scene::canDrawScenes();
    const auto figures = runDemo(context, *request);
    const auto folder = std::filesystem::absolute(request->folder);
    if (!context.is_quiet) {
      std::printf("The whole path on the virtual patient, in %.0f s:\n%s  report         %s\n",
                  figures.total_s, summary(figures).c_str(), (folder / "report.html").c_str());
      if (!has_display)
        std::printf(
            "No display here, so no window was opened; the folder holds the pictures and the video.\n");
    }
    if (has_display && !*stays_closed) playInWindow(context, folder);
  });
}

}  // namespace facenav::app
