// facenav track RECORDING [--case CASE] [--coil coil.json] -o poses.csv

#include <cmath>
#include <cstdio>

#include "commands/commands.h"
#include "facenav/workflow/track_recording.h"

namespace facenav::app {

void addTrack(CLI::App& app, Context& context) {
  auto* verb = app.add_subcommand("track", "recording -> poses of head and coil, frame by frame");
  auto request = std::make_shared<workflow::TrackRequest>();
  auto output = std::make_shared<std::filesystem::path>();
  request->aligner = context.registrations.aligners.defaultName();
  request->head_tracker = context.registrations.head_trackers.defaultName();
  request->coil_tracker = context.registrations.coil_trackers.defaultName();
  verb->add_option("RECORDING", request->recording, "recording folder")->required();
  verb->add_option("--case", request->case_folder,
                   "case folder: poses in the MRI's frame, aligned from the recording's capture/");
  verb->add_option("--coil", request->coil_file, "coil.json (without it: one 60 mm marker, 4x4_50, id 7)");
  verb->add_flag("--keep-looks", request->keeps_key_frames,
                 "keep with the case how the face looked, so that it is found at once in the next session");
  verb->add_option("-o,--output", *output, "poses.csv to write")->required();
  verb->add_option("--head-tracker", request->head_tracker,
                   "method: " + workflow::namesOf(context.registrations.head_trackers))
      ->capture_default_str();
  verb->add_option("--coil-tracker", request->coil_tracker,
                   "method: " + workflow::namesOf(context.registrations.coil_trackers))
      ->capture_default_str();
  verb->add_option("--aligner", request->aligner,
                   "method: " + workflow::namesOf(context.registrations.aligners))
      ->capture_default_str();
  verb->callback([&context, request, output] {
    const auto outcome = workflow::trackRecording(context.registrations, *request, context.monitor);
    casefile::writePoses(outcome.poses, *output);
    if (context.is_quiet) return;
    std::printf("%d frames: head tracked in %d, coil in %d; %.1f ms a frame (median), %.1f ms (p99)\n",
                outcome.frames, outcome.head_tracked, outcome.coil_tracked, outcome.processing_ms_median,
                outcome.processing_ms_p99);
    if (outcome.right_late_ms != 0)
      std::printf(
          "the right camera exposes %.1f ms %s the left one: allowed for; better a trigger for both\n",
          std::abs(outcome.right_late_ms), outcome.right_late_ms > 0 ? "after" : "before");
  });
}

}  // namespace facenav::app
