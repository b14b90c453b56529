#include "facenav/guidance/dose_json.h"

#include "facenav/core/error.h"

namespace facenav::guidance {

Dose readDose(const JsonReader& json) {
  Dose dose;
  dose.pulses = json.at("pulses").integer();
  if (json.has("trains")) dose.trains = json.at("trains").integer();
  if (json.has("frequency_hz")) dose.frequency_hz = json.at("frequency_hz").number();
  if (json.has("pause_s")) dose.pause_s = json.at("pause_s").number();
  if (json.has("output_pct")) dose.output_pct = json.at("output_pct").number();
  if (json.has("threshold_pct")) dose.threshold_pct = json.at("threshold_pct").number();
  try {
    requireSensible(dose);
  } catch (const Error& fault) {
    json.at("pulses").refuse(fault.what());
  }
  return dose;
}

std::vector<std::pair<std::string, double>> doseNumbers(const Dose& dose) {
  std::vector<std::pair<std::string, double>> numbers{{"pulses", dose.pulses},
                                                      {"trains", dose.trains},
                                                      {"frequency_hz", dose.frequency_hz},
                                                      {"pause_s", dose.pause_s}};
  if (dose.output_pct) numbers.emplace_back("output_pct", *dose.output_pct);
  if (dose.threshold_pct) numbers.emplace_back("threshold_pct", *dose.threshold_pct);
  return numbers;
}

}  // namespace facenav::guidance
