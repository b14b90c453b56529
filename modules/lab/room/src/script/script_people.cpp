#include <cmath>

#include "script_setting.h"

namespace facenav::room {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;

/// The parts of "other_face", in order: end (0..1), event.
const Parts kOtherFaceParts({{0.15, "patient"},
                             {0.30, "another person in the patient's place"},
                             {0.45, "patient"},
                             {0.55, "patient leaves"},
                             {0.65, "another person comes in"},
                             {0.75, "another person in the patient's place"},
                             {0.82, "another person leaves"},
                             {0.90, "patient comes back"},
                             {1.01, "patient"}});

}  // namespace

MomentOf glintScript(const Setting& setting) {
  return [setting](double frame) {
    const double t = setting.time_s(frame), part = setting.part(frame);
    Moment moment;
    Vector6 by = sway(t, 2.5 * setting.options.motion);
    by[1] += 8.0 * setting.options.motion * std::sin(2 * M_PI * part);
    moment.cast = setting.headMovedBy(by);
    moment.cast.wetness = ease(5.0 * part);
    moment.label = "wet skin";
    return moment;
  };
}

MomentOf maskScript(const Setting& setting) {
  return [setting](double frame) {
    Moment moment;
    Vector6 by = sway(setting.time_s(frame), setting.options.motion);
    by[1] += 8.0 * setting.options.motion * std::sin(2 * M_PI * setting.part(frame));
    moment.cast = setting.headMovedBy(by);
    moment.cast.has_mask = true;
    moment.label = "surgical mask";
    return moment;
  };
}

MomentOf otherFaceScript(const Setting& setting) {
  return [setting](double frame) {
    const double part = setting.part(frame);
    const auto [label, inside] = kOtherFaceParts.at(part);
    Moment moment;
    moment.label = label;
    Vector6 by = sway(setting.time_s(frame), setting.options.motion);
    if (moment.label == "patient leaves") by[3] += kAway_mm * ease(inside);
    if (moment.label == "another person comes in") by[3] += kAway_mm * ease(1.0 - inside);
    if (moment.label == "another person leaves") by[3] += kAway_mm * ease(inside);
    if (moment.label == "patient comes back") by[3] += kAway_mm * ease(1.0 - inside);
    moment.cast = setting.headMovedBy(by);
    const bool is_other = moment.label.rfind("another person", 0) == 0;
    // Two persons: the one who walks in differs from the one who appeared suddenly.
    if (is_other) moment.cast.stranger = 2 * setting.options.seed + (part > 0.5 ? 2 : 1);
    return moment;
  };
}

}  // namespace facenav::room
