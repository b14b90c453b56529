// facenav guide CASE poses.csv --target NAME -o guidance.csv; with --live RIG as a session of the case

#include <algorithm>
#include <cstdio>

#include "commands/commands.h"
#include "commands/session_verb.h"
#include "commands/two_coils.h"
#include "facenav/align/align_from_capture.h"
#include "facenav/cameras/projector_model.h"
#include "facenav/casefile/case_coil.h"
#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "facenav/measured_face/skin_model.h"
#include "facenav/pictures/projected_guide.h"
#include "facenav/scene/png.h"
#include "facenav/treat/guide_poses.h"
#include "json_output.h"
#include "wrong_usage.h"

namespace facenav::app {
namespace {

struct GuideRequest {
  std::filesystem::path case_folder, poses, output, projector, projected;
  std::string target;
  std::optional<std::int64_t> frame;
  bool is_json = false;
};

/// Writes the projector's picture for one frame; by default the last frame in which the head was tracked.
void writeProjected(const GuideRequest& request, const casefile::CaseStore& store,
                    const std::vector<casefile::PoseRow>& poses,
                    const std::vector<guidance::GuidanceRow>& rows) {
  const auto projector = cameras::readProjector(request.projector);
  const auto target = store.targets().find(request.target);
  std::optional<RigidTransform<Camera, Mri>> camera_T_mri;
  std::int64_t frame = request.frame.value_or(-1);
  for (const auto& row : poses) {
    if (row.object != casefile::PoseObject::head || (request.frame && row.frame != frame)) continue;
    const auto pose = row.tracked<Camera, Mri>();
    if (!pose) continue;
    camera_T_mri = *pose;
    frame = row.frame;
  }
  const auto row =
      std::find_if(rows.begin(), rows.end(), [&](const auto& each) { return each.frame == frame; });
  if (request.frame && row == rows.end())
    throw Error("there is no frame " + std::to_string(frame), request.poses.string(),
                "frames " + std::to_string(rows.front().frame) + " to " + std::to_string(rows.back().frame) +
                    " are there");
  const auto state = row == rows.end() ? guidance::GuidanceState() : row->state;
  pictures::ProjectedGuide guide(projector, store.scalp().mesh, casefile::coilOf(store.folder()).plate);
  scene::writePng(guide.draw(camera_T_mri, target, state), request.projected);
  if (!camera_T_mri)
    std::fprintf(stderr, "note: the head is lost there: the picture is black\n");
  else if (guide.ringLit() < 1)
    std::fprintf(stderr,
                 "note: the projector's light reaches %.0f %% of the ring: turn the head, or move it\n",
                 100 * guide.ringLit());
}

void guideTable(const GuideRequest& request, const Context& context) {
  const auto store = casefile::CaseStore::open(request.case_folder);
  const auto scalp =
      registration::keptScalpField(measured_face::skinModel(store.scalp()), store.scalpField());
  const auto poses = casefile::readPoses(request.poses);
  const auto rows = steps::guidePoses(store, poses, request.target, scalp.get());
  guidance::writeGuidanceCsv(rows, request.output);
  if (!request.projected.empty()) writeProjected(request, store, poses, rows);
  const auto on_target = std::count_if(rows.begin(), rows.end(), [](const auto& row) {
    return row.state.state == guidance::State::on_target;
  });
  if (request.is_json) return printJson({{"frames", rows.size()}, {"on_target", on_target}});
  if (!context.is_quiet) std::printf("%zu frames, on target in %ld\n", rows.size(), long(on_target));
}

/// Guides live; the table is the session's own, as written while it ran.
void guideLive(const GuideRequest& request, SessionVerb session, Context& context) {
  if (!request.poses.empty() || !request.projected.empty())
    throw WrongUsage("--live guides by the cameras", "leave out POSES, --projector and --projected");
  const auto& all = context.registrations;
  session.case_folder = request.case_folder;
  session.target = request.target;
  session.aligner = all.aligners.defaultName();
  session.head_tracker = all.head_trackers.defaultName();
  session.coil_tracker = all.coil_trackers.defaultName();
  session.is_json = request.is_json;
  const auto outcome = runSession(session, context);
  writeWholeFile(request.output, readWholeFile(outcome.session / "guidance.csv"));
  copySecondTable(outcome.session / "guidance.csv", request.output);
  if (request.is_json || (!context.is_quiet && !session.has_commands)) printSession(outcome, request.is_json);
  requireWholeSession(outcome);
}

}  // namespace

void addGuide(CLI::App& app, Context& context) {
  auto* verb = app.add_subcommand(
      "guide",
      "poses of head and coil, or live cameras -> distance, tilt and twist to a target, frame by frame");
  auto request = std::make_shared<GuideRequest>();
  verb->add_option("CASE", request->case_folder, "case folder with targets.json")->required();
  verb->add_option("POSES", request->poses,
                   "poses.csv, tracked with --case and --coil; or --live, or --tracker-head");
  auto session = std::make_shared<SessionVerb>();
  addLiveSessionOptions(*verb, *session);
  addSessionOptions(*verb, *session);
  addCoilsOption(*verb, session->coil, "with --live: the coil, by name or its coil.json");
  verb->add_option("--target", request->target, "name of the target")->required();
  verb->add_option("-o,--output", request->output, "guidance.csv to write")->required();
  auto* projector =
      verb->add_option("--projector", request->projector,
                       "projector.yml: a calibrated projector (image_width, image_height, K, D, R, T)");
  auto* projected = verb->add_option("--projected", request->projected,
                                     "PNG: what the projector shows, so that outline, ring and arrow lie on "
                                     "the head; black while it is lost");
  projected->needs(projector);
  projector->needs(projected);
  verb->add_option("--frame", request->frame, "of --projected; default: the last one with the head tracked")
      ->needs(projected);
  verb->add_flag("--json", request->is_json, "the result as JSON");
  verb->callback([&context, request, session, verb] {
    refuseIdleSession(*verb, {"--live", "--tracker-head"});
    if (!session->live.rig.empty() || session->isWithoutCameras())
      return guideLive(*request, *session, context);
    if (request->poses.empty())
      throw WrongUsage("it is not said what to guide", "give POSES (poses.csv), or --live RIG");
    guideTable(*request, context);
  });
}

}  // namespace facenav::app
