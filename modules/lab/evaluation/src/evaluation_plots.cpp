#include "evaluation_plots.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "facenav/core/whole_file.h"
#include "facenav/evaluation/frame_errors.h"
#include "facenav/evaluation/svg_plot.h"
#include "facenav/geometry/rotation.h"

namespace facenav::evaluation {
namespace {

class Album {
 public:
  explicit Album(std::filesystem::path folder) : folder_(std::move(folder)) {}
  void add(const std::string& file, const PlotText& labels, const std::vector<Curve>& curves,
           const std::string& caption) {
    const bool has_points = std::any_of(curves.begin(), curves.end(),
                                        [](const Curve& c) { return !c.is_reference && !c.points.empty(); });
    if (!has_points) return;
    writeWholeFile(folder_ / file, svgPlot(labels, curves));
    figures_.push_back({caption, file});
  }
  std::vector<ReportFigure> figures() const { return figures_; }

 private:
  std::filesystem::path folder_;
  std::vector<ReportFigure> figures_;
};

Curve goalLine(const std::string& name, double level, double from, double to) {
  return {name, {{from, level}, {to, level}}, true, true};
}

/// Rotation of the head since the alignment.
double turned_deg(const RunRecord& run, const FrameRecord& frame) {
  return kDegPerRad * rotationAngle(frame.truth.head->linear() * run.true_reference.linear().transpose());
}

void addAlignments(const std::vector<RunRecord>& runs, Album& album) {
  std::map<std::string, Curve> by_head;
  double widest = 0.5;
  for (const auto& run : runs) {
    if (!run.alignment || !run.alignment->refusal.empty() || run.is_capture_repeated) continue;
    const auto& a = *run.alignment;
    const double error_mm = (a.estimated * run.target_mm - a.truth * run.target_mm).norm();
    Curve& curve = by_head[run.head];
    curve.name = run.head;
    curve.is_line = false;
    curve.points.push_back({a.bound95_mm, error_mm});
    widest = std::max(widest, a.bound95_mm);
  }
  std::vector<Curve> curves;
  for (const auto& [ignored, curve] : by_head) curves.push_back(curve);
  curves.push_back({"bound", {{0.0, 0.0}, {widest, widest}}, true, true});
  album.add(
      "alignment.svg",
      {"Alignment: true error and stated bound", "95 % bound stated (mm)", "true error at the target (mm)"},
      curves,
      "Alignment at the cortical target, one mark per capture; those above the dashed line lie outside the "
      "stated bound.");
}

void addMotion(const std::vector<RunRecord>& runs, Album& album) {
  std::vector<Curve> curves;
  double farthest = 12.5;
  for (const char* scenario : {"protractor", "free_motion"}) {
    Curve curve{scenario, {}, false};
    for (const auto& run : runs) {
      if (run.scenario != scenario) continue;
      const auto errors = frameErrors(run);
      for (std::size_t i = 0; i < errors.size(); ++i)
        if (errors[i].motion) {
          curve.points.push_back({turned_deg(run, run.frames[i]), errors[i].motion->mm});
          farthest = std::max(farthest, curve.points.back().first);
        }
    }
    curves.push_back(curve);
  }
  curves.push_back(goalLine("goal, p95: 0.6 mm", 0.6, 0.0, farthest));
  album.add("motion.svg",
            {"Head motion since the alignment", "head turned by (deg)", "error at the target (mm)"}, curves,
            "Head tracking at the cortical target, alignment apart, over the turn of the head.");
}

void addCoil(const std::vector<RunRecord>& runs, Album& album, const char* file, const char* axis,
             double FrameErrors::*over) {
  Curve position{"position (mm)", {}, false}, angle{"angle (deg)", {}, false};
  for (const auto& run : runs) {
    if (run.scenario != "coil_sweep") continue;
    for (const auto& error : frameErrors(run))
      if (error.coil) {
        position.points.push_back({error.*over, error.coil->mm});
        angle.points.push_back({error.*over, error.coil->deg});
      }
  }
  album.add(file, {"Coil's marker", axis, "error (mm, deg)"}, {position, angle},
            std::string("Coil pose in the sweep, over ") + axis + ".");
}

void addTimelines(const std::vector<RunRecord>& runs, Album& album) {
  for (const char* scenario :
       {"talking", "occlusion", "lighting", "glint", "mask", "mask_on", "other_face", "lost", "grimace",
        "grimace_other", "returns", "out_of_step", "moments", "moments_other"}) {
    std::vector<Curve> curves;
    double last_s = 0.1;
    for (const auto& run : runs) {
      if (run.scenario != scenario || curves.size() >= 6) continue;
      Curve curve{run.head + ", " + run.rig + ", seed " + std::to_string(run.seed), {}};
      const auto errors = frameErrors(run);
      for (std::size_t i = 0; i < errors.size(); ++i) {
        curve.points.push_back({run.frames[i].t_s, errors[i].motion ? errors[i].motion->mm : NAN});
        last_s = std::max(last_s, run.frames[i].t_s);
      }
      curves.push_back(curve);
    }
    if (curves.empty()) continue;
    curves.push_back(goalLine("goal, p95: 1.0 mm", 1.0, 0.0, last_s));
    album.add(
        std::string(scenario) + ".svg", {scenario, "time (s)", "error at the target (mm)"}, curves,
        std::string(scenario) + ": head at the cortical target, alignment apart; gaps are lost frames.");
  }
}

void addTimes(const std::vector<RunRecord>& runs, Album& album) {
  std::vector<double> head, coil, both;
  for (const auto& run : runs)
    for (const auto& frame : run.frames) {
      head.push_back(frame.head_ms);
      coil.push_back(frame.coil_ms);
      both.push_back(frame.head_ms + frame.coil_ms);
    }
  const auto shares = [](const std::string& name, std::vector<double> ms) {
    std::sort(ms.begin(), ms.end());
    Curve curve{name, {}};
    const std::size_t step = std::max<std::size_t>(1, ms.size() / 400);
    for (std::size_t i = 0; i < ms.size(); i += step)
      curve.points.push_back({ms[i], 100.0 * double(i + 1) / double(ms.size())});
    return curve;
  };
  if (both.empty()) return;
  album.add("time.svg", {"Processor time a stereo frame", "time (ms)", "frames done within (%)"},
            {shares("head", head),
             shares("coil", coil),
             shares("both", both),
             {"goal, p99: 6 ms", {{6, 0}, {6, 100}}, true, true}},
            "Processor time on one core, share of the frames done within it.");
}

}  // namespace

std::vector<ReportFigure> writePlots(const std::vector<RunRecord>& runs,
                                     const std::filesystem::path& folder) {
  Album album(folder);
  addAlignments(runs, album);
  addMotion(runs, album);
  addCoil(runs, album, "coil_distance.svg", "distance (mm)", &FrameErrors::coil_distance_mm);
  addCoil(runs, album, "coil_tilt.svg", "tilt (deg)", &FrameErrors::coil_tilt_deg);
  addTimelines(runs, album);
  addTimes(runs, album);
  return album.figures();
}

}  // namespace facenav::evaluation
