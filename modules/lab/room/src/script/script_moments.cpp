#include <algorithm>
#include <array>
#include <cmath>

#include "dice.h"
#include "script_setting.h"

namespace facenav::room {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;

constexpr int kHeld = 15, kAbsent = 2;  // frames of a moment; frames of the absence before it
constexpr double kShortestGap_s = 1.5, kLongestGap_s = 4.0;

struct Face {
  const char* name;
  Expression expression;
  double jaw_mm;
};

Expression made(double smile, double tongue, double lips_in, double cheeks, double brows) {
  Expression expression;
  expression.smile = smile, expression.tongue = tongue, expression.lips_in = lips_in;
  expression.cheeks = cheeks, expression.brows = brows;
  return expression;
}

/// The face at each moment; the seed sets the order.
const std::array<Face, 5>& faces() {
  static const std::array<Face, 5> all{{{"smile", made(1.0, 0.0, 0.0, 0.15, 0.1), 2.0},
                                        {"tongue out", made(0.0, 1.0, 0.0, 0.0, 0.2), 3.0},
                                        {"lips drawn in", made(0.0, 0.0, 1.0, 0.2, -0.4), 0.0},
                                        {"brows up", made(0.15, 0.0, 0.0, 0.0, 1.0), 1.0},
                                        {"jaw down", made(0.0, 0.0, 0.0, 0.3, 0.5), 11.0}}};
  return all;
}

Dice diceOfMoment(const Setting& setting, int moment) {
  return Dice(setting.options.seed * 8761 + std::uint64_t(moment) * 137 + 41);
}

Face faceOf(const Setting& setting, int moment) {
  const std::uint64_t seed = setting.options.seed, step = 1 + (seed / 5) % 4;
  Face face = faces()[std::size_t((seed + step * std::uint64_t(moment)) % faces().size())];
  Dice dice = diceOfMoment(setting, moment + 1000);
  const double strength = dice.between(0.8, 1.0);
  Expression& e = face.expression;
  for (double* part : {&e.smile, &e.tongue, &e.lips_in, &e.cheeks}) *part *= strength;
  e.brows = std::clamp(e.brows + dice.between(-0.3, 0.3), -0.6, 1.0);
  e.aside = dice.between(-1.0, 1.0);
  face.jaw_mm *= strength;
  return face;
}

/// Pose of a moment: 0.5-5 deg and 3-16 mm from the seat.
Vector6 placeOfMoment(const Setting& setting, int moment) {
  Vector6 by = Vector6::Zero();
  if (moment == 0) return by;
  Dice dice = diceOfMoment(setting, moment);
  by.head<3>() = setting.options.motion * dice.between(0.5, 5.0) * dice.direction();
  by.tail<3>() = setting.options.motion * dice.between(3.0, 16.0) * dice.direction();
  return by;
}

double gapBefore_s(const Setting& setting, int moment) {
  return moment == 0 ? 0.0 : diceOfMoment(setting, moment + 2000).between(kShortestGap_s, kLongestGap_s);
}

}  // namespace

MomentOf momentsScript(const Setting& setting) {
  const bool has_other = setting.options.name == "moments_other";
  return [setting, has_other](double frame) {
    constexpr int kEach = kAbsent + kHeld;  // the first moment starts seated
    const int number = int((frame + kAbsent) / kEach);
    const bool is_away = number > 0 && frame + kAbsent - number * kEach < kAbsent;
    const Face face = faceOf(setting, number);
    Moment moment;
    moment.visit = number;
    Vector6 by = placeOfMoment(setting, number) + sway(setting.time_s(frame), 0.5 * setting.options.motion);
    if (is_away) by[3] += kAway_mm;
    moment.cast = setting.headMovedBy(by);
    moment.cast.expression = face.expression;
    moment.cast.jaw_mm = face.jaw_mm;
    for (int before = 1; before <= number; ++before) moment.later_s += gapBefore_s(setting, before);
    if (is_away) moment.later_s -= 0.5 * gapBefore_s(setting, number);
    const bool is_other = has_other && (number == 2 || number == 3);
    if (is_other) moment.cast.stranger = 2 * setting.options.seed + 1;
    moment.label = std::string(is_other ? "another person: " : "moment: ") + face.name;
    if (is_away) moment.label = is_other ? "another person comes" : "away";
    return moment;
  };
}

}  // namespace facenav::room
