#include "demo_report.h"

#include <array>
#include <cmath>

#include "facenav/core/number_text.h"
#include "facenav/core/whole_file.h"
#include "facenav/evaluation/svg_plot.h"
#include "facenav/geometry/rotation.h"

namespace facenav::app {
namespace {

// Values from the 2010 paper, section 7.2.
constexpr double kPaperResidual_mm = 6.0, kPaperRotation_deg = 1.1, kPaperTranslation_mm = 5.0;

/// Mean absolute error over frames and axes, as the paper defines it ("around each axis", "along each axis").
struct PerAxis {
  double rotation_deg = 0, translation_mm = 0;
};

PerAxis perAxis(const evaluation::TrackingEvaluation& tracking) {
  PerAxis mean;
  for (const auto& error : tracking.errors) {
    mean.rotation_deg += error.rotation_about_deg.cwiseAbs().mean();
    mean.translation_mm += error.shift_mm.cwiseAbs().mean();
  }
  const double n = std::max<std::size_t>(1, tracking.errors.size());
  return {mean.rotation_deg / n, mean.translation_mm / n};
}

evaluation::ReportTable comparison(const DemoFigures& f) {
  const PerAxis mean = perAxis(f.protractor);
  return {"This run and the paper",
          {"quantity", "this run", "the paper (2010)"},
          {{"surface residual at alignment, maximum over the points used",
            formatted("%.2f mm", f.alignment.max_mm), formatted("%.1f mm", kPaperResidual_mm)},
           {"rotation error, mean around each axis (protractor)", formatted("%.3f°", mean.rotation_deg),
            formatted("%.1f°", kPaperRotation_deg)},
           {"translation error, mean along each axis at the cortical target (protractor)",
            formatted("%.3f mm", mean.translation_mm), formatted("%.1f mm", kPaperTranslation_mm)}}};
}

evaluation::ReportTable details(const DemoFigures& f) {
  const auto row = [](const char* name, const evaluation::TrackingEvaluation& t) -> std::vector<std::string> {
    return {name, formatted("%d of %d", t.tracked, t.frames),
            formatted("%.3f / %.3f / %.3f", t.at_point_mm.rms, t.at_point_mm.p95, t.at_point_mm.max),
            formatted("%.3f / %.3f / %.3f", t.rotation_deg.rms, t.rotation_deg.p95, t.rotation_deg.max),
            formatted("%d", t.wrong_as_tracked)};
  };
  return {"Tracking against the room's truth",
          {"sequence", "frames tracked", "error rms / p95 / max (mm)", "rotation rms / p95 / max (°)",
           "wrong poses shown as tracked"},
          {row("protractor, head at the cortical target", f.protractor),
           row("treatment, head at the cortical target", f.head), row("treatment, coil", f.coil)}};
}

evaluation::ReportTable alignmentTable(const DemoFigures& f) {
  return {"Initial alignment",
          {"quantity", "value"},
          {{"face points used", formatted("%d (%.0f %% of those offered)", f.alignment.points,
                                          100 * f.alignment.inlier_fraction)},
           {"residual rms / max", formatted("%.2f / %.2f mm", f.alignment.rms_mm, f.alignment.max_mm)},
           {"true error at the cortical target",
            formatted("%.2f mm, %.2f°", f.alignment_at_target_mm, f.alignment_rotation_deg)},
           {"predicted standard error at the target",
            f.alignment.predicted_tre_mm.empty()
                ? "-"
                : formatted("%.2f mm", f.alignment.predicted_tre_mm.begin()->second)}}};
}

evaluation::ReportTable outcome(const DemoFigures& f) {
  return {"Navigation",
          {"quantity", "value"},
          {{"frames shown as on target", formatted("%d", f.frames_on_target)},
           {"true distance of coil and target at the end", formatted("%.2f mm", f.final_distance_mm)},
           {"coil centre in the head, error rms / p95 / max",
            formatted("%.2f / %.2f / %.2f mm", f.coil_on_head_mm.rms, f.coil_on_head_mm.p95,
                      f.coil_on_head_mm.max)}}};
}

}  // namespace

void writeProtractorPlot(const evaluation::TrackingEvaluation& protractor,
                         const std::map<std::int64_t, Eigen::Isometry3d>& truth,
                         const std::filesystem::path& svg) {
  std::array<evaluation::Curve, 3> translation{
      {{"about x (pitch), mm", {}}, {"about y (yaw), mm", {}}, {"about z (roll), mm", {}}}};
  evaluation::Curve paper_mm{"paper's mean: 5.0 mm", {{-12.5, 5.0}, {12.5, 5.0}}, true, true};
  const Eigen::Isometry3d neutral = truth.empty() ? Eigen::Isometry3d::Identity() : truth.begin()->second;
  for (const auto& error : protractor.errors) {
    const Eigen::Vector3d turned_deg =
        kDegPerRad * logRotation(truth.at(error.frame).linear() * neutral.linear().transpose());
    int axis = 0;
    turned_deg.cwiseAbs().maxCoeff(&axis);
    translation[axis].points.push_back({turned_deg[axis], error.at_point_mm});
  }
  for (auto& curve : translation) std::sort(curve.points.begin(), curve.points.end());
  writeWholeFile(svg, evaluation::svgPlot({"Tracking error over the head's rotation",
                                           "rotation of the head (°)", "error at the cortical target (mm)"},
                                          {translation[0], translation[1], translation[2], paper_mm}));
}

void writeDemoReport(const DemoFigures& figures, const std::vector<evaluation::ReportFigure>& pictures,
                     const std::filesystem::path& folder) {
  std::vector<evaluation::ReportSection> sections;
  sections.push_back(
      {"Result", "", {comparison(figures), alignmentTable(figures), details(figures), outcome(figures)}, {}});
  sections.push_back({"Pictures", "", {}, pictures});
  evaluation::ReportTable times{"", {"step", "time"}, {}};
  for (const auto& [step, seconds] : figures.step_s)
    times.rows.push_back({step, formatted("%.1f s", seconds)});
  times.rows.push_back({"all", formatted("%.1f s", figures.total_s)});
  sections.push_back({"Time", "", {times}, {}});
  sections.push_back({"What this is",
                      "The patient and the room are virtual: a real T1 MRI with its face, rendered as two "
                      "cameras would see it, with "
                      "exact poses as truth. The import, brain and skin model, stereo, alignment, tracking "
                      "and guidance are the code "
                      "a real patient gets; the demo only chooses inputs. Errors are measured against the "
                      "room's truth, not against "
                      "a real camera or a phantom.",
                      {},
                      {}});
  writeWholeFile(folder / "report.html",
                 evaluation::htmlReport("FaceNav: from the MRI to the coil on target",
                                        "Virtual patient, virtual room, real code", sections));
}

std::string summary(const DemoFigures& f) {
  const PerAxis mean = perAxis(f.protractor);
  std::string out;
  out +=
      formatted("  alignment      residual max %.2f mm (paper 6.0), error at the target %.2f mm, %.2f deg\n",
                f.alignment.max_mm, f.alignment_at_target_mm, f.alignment_rotation_deg);
  out += formatted("  protractor     %.3f deg (paper 1.1), %.3f mm (paper 5.0), %d of %d frames tracked\n",
                   mean.rotation_deg, mean.translation_mm, f.protractor.tracked, f.protractor.frames);
  out += formatted("  treatment      head p95 %.2f mm, coil p95 %.2f mm, wrong poses shown as tracked: %d\n",
                   f.head.at_point_mm.p95, f.coil.at_point_mm.p95,
                   f.head.wrong_as_tracked + f.coil.wrong_as_tracked);
  out += formatted("  coil on target %d frames, true distance at the end %.2f mm\n", f.frames_on_target,
                   f.final_distance_mm);
  return out;
}

}  // namespace facenav::app
