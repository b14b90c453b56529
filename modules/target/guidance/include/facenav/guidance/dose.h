#pragma once
// Dose: how many pulses one session gives at a target, in which rhythm, and how strong. Part of a protocol
// (casefile/protocol.h); a target may have its own. The limits are those of stimulators on the market and
// catch typing errors; they are no clinical advice.

#include <optional>

namespace facenav::guidance {

struct Dose {
  int pulses = 0;                       // in one session
  int trains = 1;                       // number of trains in the session; 1: one train, or single pulses
  double frequency_hz = 0;              // within a train; 0: single pulses at no fixed rate
  double pause_s = 0;                   // from the last pulse of a train to the first of the next
  std::optional<double> output_pct;     // % of the stimulator's maximal output
  std::optional<double> threshold_pct;  // % of the resting motor threshold

  /// Pulses in each train; the last train may have fewer.
  int pulsesInTrain() const { return trains > 0 ? (pulses + trains - 1) / trains : pulses; }
  /// Duration from the first pulse to the last; nothing for single pulses at no fixed rate.
  std::optional<double> duration_s() const;

  bool operator==(const Dose& other) const;
  bool operator!=(const Dose& other) const { return !(*this == other); }
};

/// Throws Error that names the field if one is out of range: pulses 1..100000, trains 1..pulses, frequency
/// 0..100 Hz, pause 0..3600 s, output 0..100 %, 0..200 % of the threshold.
void requireSensible(const Dose& dose);

}  // namespace facenav::guidance
