#include "treat/read_out.h"

#include <QCoreApplication>
#include <cmath>

#include "facenav/geometry/rotation.h"
#include "shell/shown_words.h"

namespace facenav::ui {
namespace {

constexpr double kApart_ms = 3.0;  // time difference that is shown: 0.3 mm for a head that moves at 100 mm/s

/// The context is the one that lupdate takes for a function of this namespace.
QString tr(const char* text) { return QCoreApplication::translate("facenav::ui", text); }

/// `quality`: of a tracked one; nothing: it is lost.
Chip chip(const QString& name, std::optional<double> quality, const std::string& loss) {
  if (!quality) return {tr("%1 LOST").arg(name), shownWords(loss), Level::lost};
  const bool is_weak = *quality < 0.4;
  return {is_weak ? tr("%1 weak").arg(name) : tr("%1 tracked").arg(name),
          tr("quality %1").arg(*quality, 0, 'f', 2), is_weak ? Level::caution : Level::good};
}

template <class T>
std::optional<double> qualityOf(const Tracked<T>& tracked) {
  return tracked ? std::optional(double(tracked.quality())) : std::nullopt;
}

/// Formats with one decimal below 100 mm, none above, so that the figure never needs more width.
QString millimetres(double value_mm) {
  return QString::number(value_mm, 'f', std::abs(value_mm) < 99.95 ? 1 : 0);
}

QString whole(double degrees, bool is_signed) {
  const long value = std::lround(degrees);
  return (is_signed && value > 0 ? QStringLiteral("+") : QString()) + QString::number(value) + QChar(0x00b0);
}

/// Adds the gap by both poses, the field lost by it, and the gap that the cameras measure beside the coil.
void addGap(const guidance::CoilGap& gap, ReadOut& out) {
  if (!gap.by_poses_mm) return;
  out.gap = tr("gap %1 mm, field \u2212%2 %")
                .arg(*gap.by_poses_mm, 0, 'f', 1)
                .arg(guidance::fieldLost_pct(*gap.by_poses_mm), 0, 'f', 0);
  out.gap_tip =
      tr("contact face's centre above the MRI's skin, by the poses of head and coil; the field is lost "
         "against a coil that touches the skin");
  if (const auto seen_mm = gap.byStereo_mm()) {
    out.gap += tr("; seen %1 mm").arg(*seen_mm, 0, 'f', 1);
    out.gap_tip += tr("; seen: above the surface (skin or hair) that both cameras measure beside the coil");
  } else if (!gap.unseen.empty()) {
    out.gap_tip += "; " + shownWords(gap.unseen);
  }
  out.gap_disagrees = gap.disagrees();
  if (!out.gap_disagrees) return;
  out.gap = "! " + out.gap;
  out.gap_tip = shownWords(disagreementInWords(gap)) + ". " + out.gap_tip;
}

/// The second coil in one line. Lost: its name and why, without a figure.
QString secondInWords(const session::NavigationState& state) {
  if (!state.second) return {};
  const QString name = QString::fromStdString(state.second->name);
  const std::string loss = session::secondCoilLossInWords(state);
  if (!loss.empty()) return tr("%1: %2").arg(name, shownWords(loss).section(':', 0, 0));
  const auto& g = state.second->guidance;
  if (!g.values || g.state == guidance::State::lost)
    return state.camera_T_mri && !state.second->chosen ? tr("%1: tracked, no target").arg(name)
                                                       : tr("%1: tracked").arg(name);
  const double depth_mm = std::abs(g.values->depth_mm) < 0.05 ? 0.0 : g.values->depth_mm;
  return tr("%1: %2, across %3, depth %4 mm, tilt %5")
      .arg(name, g.state == guidance::State::on_target ? tr("on target") : tr("adjust"),
           millimetres(g.values->lateral_mm),
           (depth_mm > 0 ? QStringLiteral("+") : QString()) + millimetres(depth_mm),
           whole(g.values->tilt_rad * kDegPerRad, false));
}

}  // namespace

ReadOut makeReadOut(const session::NavigationState& state) {
  ReadOut out;
  const QString dash(QChar(0x2013));
  out.across = out.depth = out.tilt = out.twist = dash;
  const bool has_images = state.images != nullptr && state.images->absence.empty() && state.failure.empty();
  const bool is_stale =
      !state.head && (state.head.reason() == LostReason::stale || state.head.reason() == LostReason::camera);
  out.cameras = {has_images && !is_stale ? tr("CAMERAS on") : tr("CAMERAS no images"), QString(),
                 has_images && !is_stale ? Level::good : Level::lost};
  const double apart_ms = 1e3 * std::abs(state.exposure_offset.right_late_s);
  if (out.cameras.level == Level::good && apart_ms >= kApart_ms)
    out.cameras = {tr("CAMERAS %1 ms apart").arg(apart_ms, 0, 'f', 0),
                   tr("one camera exposes later than the other; the head's motion in between is allowed for, "
                      "but a trigger for both is better"),
                   Level::caution};
  out.face = chip(tr("FACE"), qualityOf(state.head), session::headLossInWords(state));
  out.coil = chip(tr("COIL"), qualityOf(state.coil), session::coilLossInWords(state));
  out.timing = tr("%1 ms   %2 dropped").arg(state.latency_ms, 0, 'f', 1).arg(qulonglong(state.dropped));
  addGap(state.gap, out);
  out.second = secondInWords(state);
  const auto& g = state.guidance;
  const bool has_values = g.values.has_value() && g.state != guidance::State::lost;
  if (has_values) {
    out.across = millimetres(g.values->lateral_mm);
    const double depth_mm = std::abs(g.values->depth_mm) < 0.05 ? 0.0 : g.values->depth_mm;
    out.depth = (depth_mm > 0 ? QStringLiteral("+") : QString()) + millimetres(depth_mm);
    out.tilt = whole(g.values->tilt_rad * kDegPerRad, false);
    out.twist = whole(g.values->twist_rad * kDegPerRad, true);
    if (state.chosen && state.chosen->error_bound_mm > 0)
      out.predicted = tr("95 % within %1 mm at the target").arg(state.chosen->error_bound_mm, 0, 'f', 1);
    out.level = g.state == guidance::State::on_target ? Level::good : Level::caution;
    const QString words = shownWords(g.instruction);
    out.instruction = out.level == Level::good ? tr("ON TARGET: %1").arg(words) : tr("ADJUST: %1").arg(words);
  } else {
    const QString loss = shownWords(session::lossInWords(state));
    out.instruction = !loss.isEmpty()        ? loss
                      : state.target.empty() ? tr("choose a target")
                                             : shownWords(g.instruction);
  }
  return out;
}

ReadOut whilePaused(ReadOut read_out, const QString& words) {
  read_out.across = read_out.depth = read_out.tilt = read_out.twist = QString(QChar(0x2013));
  read_out.predicted.clear();
  read_out.gap.clear();
  read_out.gap_tip.clear();
  read_out.gap_disagrees = false;
  read_out.second.clear();
  read_out.instruction = words;
  read_out.level = Level::idle;
  return read_out;
}

}  // namespace facenav::ui
