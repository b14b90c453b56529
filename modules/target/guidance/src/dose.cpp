#include "facenav/guidance/dose.h"

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"

namespace facenav::guidance {
namespace {

void requireRange(const char* field, double value, double low, double high, const char* unit) {
  if (value >= low && value <= high) return;
  throw Error(formatted("%s is %g; %g to %g%s was expected", field, value, low, high, unit), {},
              "check the protocol");
}

}  // namespace

std::optional<double> Dose::duration_s() const {
  if (!(frequency_hz > 0) || pulses < 1) return std::nullopt;
  const int in_train = pulsesInTrain(), used = (pulses + in_train - 1) / in_train;
  return (pulses - used) / frequency_hz + (used - 1) * pause_s;
}

bool Dose::operator==(const Dose& other) const {
  return pulses == other.pulses && trains == other.trains && frequency_hz == other.frequency_hz &&
         pause_s == other.pause_s && output_pct == other.output_pct && threshold_pct == other.threshold_pct;
}

void requireSensible(const Dose& dose) {
  requireRange("pulses", dose.pulses, 1, 100000, "");
  requireRange("trains", dose.trains, 1, dose.pulses, ", no more than there are pulses,");
  requireRange("frequency_hz", dose.frequency_hz, 0, 100, " Hz");
  requireRange("pause_s", dose.pause_s, 0, 3600, " s");
  if (dose.output_pct) requireRange("output_pct", *dose.output_pct, 0, 100, " %");
  if (dose.threshold_pct) requireRange("threshold_pct", *dose.threshold_pct, 0, 200, " %");
}

}  // namespace facenav::guidance
