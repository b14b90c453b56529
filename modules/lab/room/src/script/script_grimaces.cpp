#include <algorithm>
#include <array>
#include <cmath>

#include "dice.h"
#include "script_setting.h"

namespace facenav::room {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;

// "grimace": frames at rest, then repeatedly away and back.
constexpr int kRest = 10, kAway = 2, kBack = 15;
constexpr double kGap_s = 1.4;  // pause without frames, half before and half after the frames away

// "returns": the patient stands up, walks out of the images and walks in again.
constexpr int kWalk = 15,
              kSeated = 16;  // frames of each walk (0.25 s at 60 Hz, as in "other_face"); frames seated
constexpr double kLargestTurn_deg = 15.0;

// "out_of_step".
constexpr int kInStep = 24;
constexpr double kRadius_mm = 6.0, kRounds_hz = 1.0;  // the head moves on a circle

/// Return that a frame belongs to (0: at rest before the first), and whether the patient is still away.
struct Visit {
  int number = 0;
  bool is_away = false;
};

Visit visitOf(double frame) {
  if (frame < kRest) return {};
  const double since = frame - kRest;
  const int before = int(since / (kAway + kBack));
  return {1 + before, since - before * (kAway + kBack) < kAway};
}

Dice diceOf(const Setting& setting, int visit) {
  return Dice(setting.options.seed * 9973 + std::uint64_t(visit) * 131 + 7);
}

/// Pose of the patient after a return: 0.5-5 deg and 3-16 mm from the seat.
Vector6 placeOf(const Setting& setting, int visit) {
  Vector6 by = Vector6::Zero();
  if (visit == 0) return by;
  Dice dice = diceOf(setting, visit);
  const double turn_deg = dice.between(0.5, 5.0), shift_mm = dice.between(3.0, 16.0);
  by.head<3>() = setting.options.motion * turn_deg * dice.direction();
  by.tail<3>() = setting.options.motion * shift_mm * dice.direction();
  return by;
}

struct Grimace {
  const char* name;
  double Expression::*part;
};
constexpr std::array<Grimace, 5> kGrimaces{{{"smile", &Expression::smile},
                                            {"tongue out", &Expression::tongue},
                                            {"lips drawn in", &Expression::lips_in},
                                            {"cheeks puffed", &Expression::cheeks},
                                            {"brows raised", &Expression::brows}}};

/// Grimace of a visit: one of five, in an order set by the seed; each includes the brows.
const Grimace& grimaceOf(const Setting& setting, int visit) {
  const int first = int(setting.options.seed % kGrimaces.size()), step = setting.options.seed % 2 ? 1 : 2;
  return kGrimaces[std::size_t(first + step * visit) % kGrimaces.size()];
}

Expression expressionOf(const Setting& setting, int visit) {
  Expression expression;
  if (visit == 0) return expression;
  Dice dice = diceOf(setting, visit + 1000);
  expression.brows = dice.between(-0.4, 0.6);
  expression.*grimaceOf(setting, visit).part = dice.between(0.75, 1.0);
  return expression;
}

/// Pose of the patient after an absence: 5 to 15 deg and 3 to 16 mm from the seat.
Vector6 turnedPlaceOf(const Setting& setting, int visit) {
  Vector6 by = Vector6::Zero();
  if (visit == 0) return by;
  Dice dice = diceOf(setting, visit + 2000);
  by.head<3>() = setting.options.motion * dice.between(5.0, kLargestTurn_deg) * dice.direction();
  by.tail<3>() = setting.options.motion * dice.between(3.0, 16.0) * dice.direction();
  return by;
}

/// Changes lamps by up to 35 % and moves them by up to 600 mm, as after opening a door or a blind.
void otherLight(const Setting& setting, int visit, Cast& cast) {
  if (visit == 0) return;
  Dice dice = diceOf(setting, visit + 3000);
  cast.lamp_scale = dice.between(0.65, 1.35);
  cast.ambient_scale = dice.between(0.8, 1.2);
  cast.lamp_shift_mm = dice.between(200.0, 600.0) * dice.direction();
}

}  // namespace

Expression captureExpression(const ScenarioOptions& options) {
  Expression expression;
  if (options.capture_grimace <= 0) return expression;
  Dice dice(options.seed * 4001 + 11);
  expression.brows = options.capture_grimace * dice.between(-0.4, 0.6);
  expression.*kGrimaces[std::size_t(options.seed % kGrimaces.size())].part = options.capture_grimace;
  return expression;
}

MomentOf grimaceScript(const Setting& setting) {
  const bool has_other = setting.options.name == "grimace_other";
  return [setting, has_other](double frame) {
    const Visit visit = visitOf(frame);
    Moment moment;
    moment.visit = visit.number;
    Vector6 by = placeOf(setting, visit.number) + sway(setting.time_s(frame), 0.5 * setting.options.motion);
    if (visit.is_away) by[3] += kAway_mm;
    moment.cast = setting.headMovedBy(by);
    moment.cast.expression = expressionOf(setting, visit.number);
    moment.later_s = kGap_s * (visit.number - (visit.is_away ? 0.5 : 0.0));
    const bool is_other = has_other && visit.number == 2;
    if (is_other) moment.cast.stranger = 2 * setting.options.seed + 1;
    moment.label = visit.number == 0 ? "at rest"
                   : visit.is_away   ? "away"
                                     : std::string("back: ") + grimaceOf(setting, visit.number).name;
    if (is_other) moment.label = visit.is_away ? "another person comes" : "another person: grimace";
    return moment;
  };
}

MomentOf returnsScript(const Setting& setting) {
  return [setting](double frame) {
    constexpr int kVisit = kSeated + 2 * kWalk;  // walk in, seated, walk out
    // A visit starts with the walk in; the first one starts seated.
    const int number = int((frame + kWalk) / kVisit);
    const double inside = frame + kWalk - number * kVisit;  // frames since the walk in began
    const bool is_coming = inside < kWalk, is_going = inside >= kWalk + kSeated;
    Moment moment;
    moment.visit = number;
    Vector6 by = sway(setting.time_s(frame), 0.5 * setting.options.motion);
    by += turnedPlaceOf(setting, number);
    if (is_coming) by[3] += kAway_mm * ease(1.0 - inside / kWalk);
    if (is_going) by[3] += kAway_mm * ease((inside - kWalk - kSeated + 1.0) / kWalk);
    moment.cast = setting.headMovedBy(by);
    moment.cast.expression = expressionOf(setting, number);
    moment.later_s = kGap_s * number;
    otherLight(setting, number, moment.cast);
    moment.label = number == 0 ? "at rest" : std::string("back: ") + grimaceOf(setting, number).name;
    if (is_going) moment.label = "patient leaves";
    if (is_coming) moment.label = "patient comes back";
    return moment;
  };
}

MomentOf outOfStepScript(const Setting& setting) {
  return [setting](double frame) {
    const double t = setting.time_s(frame), angle = 2.0 * M_PI * kRounds_hz * t;
    Vector6 by = sway(t, 0.5);
    by.tail<3>() += kRadius_mm * Eigen::Vector3d(std::cos(angle) - 1.0, 0.0, std::sin(angle));
    Moment moment;
    moment.cast = setting.headMovedBy(by);
    moment.label = frame < kInStep ? "in step" : "right camera's picture is older";
    if (frame < kInStep) return moment;
    // The head's shift between the two exposures (chord of the circle) grows from 4 to 9 mm.
    const double share = std::min(1.0, (frame - kInStep) / std::max(1, setting.frames - 1 - kInStep));
    const double chord_mm = 4.0 + 5.0 * share;
    const double between_s = std::asin(chord_mm / (2.0 * kRadius_mm)) / (M_PI * kRounds_hz);
    moment.right_behind = between_s * setting.options.frames_per_s;
    return moment;
  };
}

}  // namespace facenav::room
