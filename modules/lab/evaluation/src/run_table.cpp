#include "facenav/evaluation/run_table.h"

#include <cmath>
#include <limits>
#include <sstream>

#include "facenav/evaluation/error_statistics.h"
#include "facenav/evaluation/frame_errors.h"
#include "facenav/geometry/rotation.h"

namespace facenav::evaluation {
namespace {

using Figures = std::vector<std::pair<std::string, double>>;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

void addCloud(const RunRecord& run, Figures& figures) {
  const bool has = run.cloud.has_value();
  figures.push_back({"cloud_rms_mm", has ? run.cloud->rms_mm : kNone});
  figures.push_back({"cloud_predicted_mm", has ? run.cloud->predicted_mm : kNone});
  figures.push_back({"cloud_gross_percent", has ? run.cloud->gross_percent : kNone});
  figures.push_back({"cloud_coverage_percent", has ? run.cloud->coverage_percent : kNone});
  figures.push_back({"cloud_mean_mm", has ? run.cloud->mean_mm : kNone});
  for (std::size_t lag = 0; lag + 1 < CloudFigures::kLags_mm.size(); ++lag)
    figures.push_back({"cloud_shared_mm2_from_" + std::to_string(int(CloudFigures::kLags_mm[lag])) + "_mm",
                       has ? run.cloud->shared_mm2[lag] : kNone});
}

void addAlignment(const RunRecord& run, Figures& figures) {
  const bool has = run.alignment && run.alignment->refusal.empty();
  const AlignmentRecord a = has ? *run.alignment : AlignmentRecord{};
  const double error_mm = (a.estimated * run.target_mm - a.truth * run.target_mm).norm();
  const double error_deg = kDegPerRad * rotationAngle(a.estimated.linear().transpose() * a.truth.linear());
  figures.push_back({"alignment_target_mm", has ? error_mm : kNone});
  figures.push_back({"alignment_deg", has ? error_deg : kNone});
  figures.push_back({"alignment_predicted_mm", has ? a.predicted_mm : kNone});
  figures.push_back({"alignment_bound95_mm", has ? a.bound95_mm : kNone});
  figures.push_back({"alignment_residual_rms_mm", has ? a.rms_mm : kNone});
  figures.push_back({"alignment_fit_ms", has ? a.fit_ms : kNone});
  figures.push_back({"alignment_measure_ms", has ? a.measure_ms : kNone});
}

/// Adds rms, p95 and max of the distances, rms of the angles.
void addErrors(const std::string& name, const std::vector<FrameErrors>& frames,
               std::optional<ErrorAt> FrameErrors::*which, Figures& figures) {
  std::vector<double> mm, deg;
  for (const auto& frame : frames)
    if (frame.*which) mm.push_back((frame.*which)->mm), deg.push_back((frame.*which)->deg);
  const auto at = summarise(mm), turned = summarise(deg);
  figures.push_back({name + "_rms_mm", mm.empty() ? kNone : at.rms});
  figures.push_back({name + "_p95_mm", mm.empty() ? kNone : at.p95});
  figures.push_back({name + "_max_mm", mm.empty() ? kNone : at.max});
  figures.push_back({name + "_rms_deg", mm.empty() ? kNone : turned.rms});
}

void addCounts(const RunRecord& run, const std::vector<FrameErrors>& errors, Figures& figures) {
  int head = 0, coil = 0, in_view = 0, coil_in_view = 0, head_wrong = 0, coil_wrong = 0, knowable = 0;
  for (std::size_t i = 0; i < run.frames.size(); ++i) {
    const FrameRecord& frame = run.frames[i];
    head += frame.head_motion.has_value();
    coil += frame.marker.has_value();
    in_view += frame.is_marker_in_view;
    coil_in_view += frame.is_marker_in_view && frame.marker;
    knowable += !frame.truth.must_be_lost && frame.truth.head;
    head_wrong += errors[i].is_head_wrong;
    coil_wrong += errors[i].is_coil_wrong;
  }
  figures.push_back({"frames", double(run.frames.size())});
  figures.push_back({"frames_head_knowable", double(knowable)});
  figures.push_back({"frames_head_tracked", double(head)});
  figures.push_back({"frames_marker_in_view", double(in_view)});
  figures.push_back({"frames_marker_in_view_tracked", double(coil_in_view)});
  figures.push_back({"frames_coil_tracked", double(coil)});
  figures.push_back({"head_wrong_as_tracked", double(head_wrong)});
  figures.push_back({"coil_wrong_as_tracked", double(coil_wrong)});
  figures.push_back({"longest_loss_s", longestLoss_s(run)});
  const auto again = timesToFindAgain_s(run);
  figures.push_back({"found_again_max_s", again.empty() ? kNone : summarise(again).max});
}

void addTimes(const RunRecord& run, Figures& figures) {
  std::vector<double> head, coil, both;
  for (const auto& frame : run.frames) {
    head.push_back(frame.head_ms);
    coil.push_back(frame.coil_ms);
    both.push_back(frame.head_ms + frame.coil_ms);
  }
  const bool has = !both.empty();
  figures.push_back({"head_median_ms", has ? quantile(head, 0.5) : kNone});
  figures.push_back({"coil_median_ms", has ? quantile(coil, 0.5) : kNone});
  figures.push_back({"frame_median_ms", has ? quantile(both, 0.5) : kNone});
  figures.push_back({"frame_p99_ms", has ? quantile(both, 0.99) : kNone});
}

std::string quoted(std::string text) {
  for (char& c : text)
    if (c == '"' || c == '\n') c = '\'';
  return '"' + text + '"';
}

/// Quotes a text if needed: a recording is named by its folder, a scenario's name is plain.
std::string quotedIfNeeded(const std::string& text) {
  return text.find_first_of(",\"\n") == std::string::npos ? text : quoted(text);
}

}  // namespace

Figures figuresOf(const RunRecord& run) {
  const auto errors = frameErrors(run);
  Figures figures;
  addCloud(run, figures);
  addAlignment(run, figures);
  addCounts(run, errors, figures);
  addErrors("motion", errors, &FrameErrors::motion, figures);
  addErrors("head", errors, &FrameErrors::head, figures);
  addErrors("coil", errors, &FrameErrors::coil, figures);
  addErrors("coil_on_head", errors, &FrameErrors::relative, figures);
  figures.push_back({"jitter_mm", run.scenario == "still" && !run.frames.empty() ? jitter_mm(run) : kNone});
  addTimes(run, figures);
  return figures;
}

std::string runsCsv(const std::vector<RunRecord>& runs) {
  std::ostringstream csv;
  csv.imbue(std::locale::classic());
  csv.precision(6);
  csv << "scenario,head,rig,seed,failure";
  for (const auto& [name, ignored] : figuresOf(RunRecord{})) csv << ',' << name;
  csv << ",from,must_be_refused,right_turn_deg,right_turn_sigma_deg,camera_noticed_deg,coil_on_target_mm,"
         "coil_on_target_bound95_mm,coil_withheld\n";
  for (const RunRecord& run : runs) {
    const std::string failure = run.failure.empty() && run.alignment ? run.alignment->refusal : run.failure;
    csv << quotedIfNeeded(run.scenario) << ',' << quoted(run.head) << ',' << quoted(run.rig) << ','
        << run.seed << ',' << (failure.empty() ? "" : quoted(failure));
    for (const auto& [ignored, value] : figuresOf(run)) {
      csv << ',';
      if (std::isfinite(value)) csv << value;
    }
    csv << ',' << run.from << ',' << (run.must_be_refused ? "1" : "") << ',';
    if (run.alignment && run.alignment->turn_deg)
      csv << *run.alignment->turn_deg << ',' << run.alignment->turn_sigma_deg;
    else
      csv << ',';
    csv << ',';
    if (const auto noticed = cameraNoticedAt(run)) csv << run.frames[*noticed].truth.camera_turn_deg;
    csv << ',';
    if (run.alignment && run.alignment->coil_mm)
      csv << *run.alignment->coil_mm << ',' << run.alignment->coil_bound95_mm << ','
          << (run.alignment->is_coil_withheld ? "1" : "");
    else
      csv << ",,";
    csv << '\n';
  }
  return csv.str();
}

}  // namespace facenav::evaluation
