#pragma once
// Synthetic sound of a treatment room with a known answer: clicks of a coil with echoes, over hum and
// something like speech (voiced sounds, "s", "t" and "k", pauses). For tests of the detector of clicks.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace facenav::testing {

struct MadeClicks {
  double samples_per_s = 48000;
  int pulses = 200, in_train = 20;
  double step_s = 0.1, pause_s = 0.7;
  double over_speech_db = 30;  // peak of the clicks against the speech's rms; infinite: no speech
  double hum = 0.02;           // peak of the hum; the clicks' is 0.5
  double shortest_ms = 0.3, longest_ms = 3;
  unsigned seed = 1;
};

struct ClickSound {
  std::vector<float> samples;
  std::vector<double> clicks_s;  // onset times
};

class SpeechMaker {
 public:
  SpeechMaker(double samples_per_s, unsigned seed) : rate_(samples_per_s), random_(seed) {}
  /// Makes speech of rms 1 while it sounds.
  std::vector<double> make(std::size_t count) {
    std::vector<double> sound(count, 0.0);
    for (std::size_t at = 0; at < count;) {
      const double kind = uniform(0, 1);
      const auto length = std::size_t(rate_ * (kind < 0.15 ? uniform(0.1, 0.5) : uniform(0.06, 0.25)));
      if (kind < 0.15) {
      } else if (kind < 0.65) {
        voiced(sound, at, length);
      } else if (kind < 0.85) {
        hiss(sound, at, length, 0.02 + 0.02 * uniform(0, 1), 0.25);
      } else {
        hiss(sound, at + std::size_t(0.05 * rate_), std::size_t(rate_ * uniform(0.008, 0.03)), 0.0008, 0.4);
      }
      at += length;
    }
    double squares = 0, sounding = 1;
    for (const double s : sound) squares += s * s, sounding += std::abs(s) > 1e-3;
    for (double& s : sound) s /= std::sqrt(squares / sounding);
    return sound;
  }

 private:
  double uniform(double a, double b) { return std::uniform_real_distribution<double>(a, b)(random_); }
  /// Adds beats of the vocal cords through three resonances.
  void voiced(std::vector<double>& sound, std::size_t at, std::size_t length) {
    const double pitch_hz = uniform(80, 240);
    const std::array<std::array<double, 2>, 4> formants{
        {{uniform(300, 800), 80}, {uniform(900, 2300), 120}, {uniform(2300, 3200), 180}, {3800, 250}}};
    const std::array<double, 4> gains{1, 0.5, 0.25, 0.15};
    for (double beat = 0; beat < double(length); beat += rate_ / (pitch_hz * uniform(0.97, 1.03))) {
      const double swell = std::sin(M_PI * beat / double(length));
      for (std::size_t i = 0; i < std::size_t(0.02 * rate_) && at + std::size_t(beat) + i < sound.size();
           ++i) {
        const double t_s = double(i) / rate_;
        for (std::size_t k = 0; k < 4; ++k)
          sound[at + std::size_t(beat) + i] += swell * gains[k] * std::exp(-M_PI * formants[k][1] * t_s) *
                                               std::sin(2 * M_PI * formants[k][0] * t_s);
      }
    }
  }
  /// Adds noise that rises within `rise_s`.
  void hiss(std::vector<double>& sound, std::size_t at, std::size_t length, double rise_s, double gain) {
    std::normal_distribution<double> noise(0, 1);
    double before = 0;
    for (std::size_t i = 0; i < length && at + i < sound.size(); ++i) {
      const double t_s = double(i) / rate_, left_s = double(length - i) / rate_;
      const double n = noise(random_);
      sound[at + i] += gain * (n - 0.7 * before) * std::min(1.0, t_s / rise_s) * std::min(1.0, left_s / 0.01);
      before = n;
    }
  }
  double rate_;
  std::mt19937 random_;
};

/// Click of one coil, always about alike.
struct MadeCoil {
  double length_s = 1e-3, low_hz = 3000, high_hz = 7000;
};

inline void addClick(ClickSound& sound, double at_s, const MadeClicks& made, const MadeCoil& coil,
                     std::mt19937& random) {
  const auto uniform = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random);
  };
  const double length_s = coil.length_s * uniform(0.9, 1.1);
  const double low_hz = coil.low_hz * uniform(0.97, 1.03), high_hz = coil.high_hz * uniform(0.97, 1.03);
  const auto ring = [&](double t_s) {
    return std::exp(-3 * t_s / length_s) *
           (std::sin(2 * M_PI * low_hz * t_s) + 0.6 * std::sin(2 * M_PI * high_hz * t_s));
  };
  double peak = 0;
  for (double t_s = 0; t_s < length_s; t_s += 1 / made.samples_per_s)
    peak = std::max(peak, std::abs(ring(t_s)));
  const auto put = [&](double from_s, double gain) {
    for (auto i = std::size_t(std::ceil(from_s * made.samples_per_s)); i < sound.samples.size(); ++i) {
      const double t_s = double(i) / made.samples_per_s - from_s;
      if (t_s > 2 * length_s) break;
      sound.samples[i] += float(0.5 * gain / peak * ring(t_s));
    }
  };
  put(at_s, uniform(0.7, 1));
  const int echoes = std::uniform_int_distribution<int>(2, 6)(random);
  for (int i = 0; i < echoes; ++i) put(at_s + uniform(0.002, 0.03), std::pow(10, -uniform(12, 28) / 20));
  sound.clicks_s.push_back(at_s);
}

inline ClickSound madeSound(const MadeClicks& made) {
  std::mt19937 random(made.seed);
  const int trains = (made.pulses + made.in_train - 1) / std::max(1, made.in_train);
  const double length_s = 2 + made.pulses * made.step_s + trains * made.pause_s;
  ClickSound sound;
  const auto count = std::size_t(length_s * made.samples_per_s);
  sound.samples.resize(count);
  if (std::isfinite(made.over_speech_db)) {
    const auto speech = SpeechMaker(made.samples_per_s, made.seed + 1000).make(count);
    const double gain = 0.5 / std::pow(10, made.over_speech_db / 20);
    for (std::size_t i = 0; i < count; ++i) sound.samples[i] = float(gain * speech[i]);
  }
  std::normal_distribution<double> hiss(0, 0.0005);
  for (std::size_t i = 0; i < count; ++i) {
    const double t_s = double(i) / made.samples_per_s;
    double hum = 0;
    for (const int harmonic : {1, 2, 3, 5, 7})
      hum += std::sin(2 * M_PI * 50 * harmonic * t_s + harmonic) / harmonic;
    sound.samples[i] += float(made.hum * hum + hiss(random));
  }
  const auto uniform = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random);
  };
  const MadeCoil coil{1e-3 * std::exp(uniform(std::log(made.shortest_ms), std::log(made.longest_ms))),
                      uniform(1500, 5000), uniform(5000, 9000)};
  for (int i = 0; i < made.pulses; ++i)
    addClick(sound, 1.0 + i * made.step_s + (i / made.in_train) * made.pause_s + 0.00037 * (i % 5), made,
             coil, random);
  for (float& s : sound.samples) s = std::clamp(s, -1.f, 1.f);
  return sound;
}

/// Result of a detector.
struct ClickScore {
  int missed = 0, wrong = 0, doubled = 0;
  double worst_ms = 0, mean_ms = 0;
};

/// Scores a detector: a click is found if one is reported within 5 ms of it.
inline ClickScore scoreOf(const std::vector<double>& truth_s, const std::vector<double>& told_s) {
  constexpr double kSame_s = 0.005;
  ClickScore score;
  std::vector<int> times(truth_s.size(), 0);
  int found = 0;
  for (const double at_s : told_s) {
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < truth_s.size(); ++i)
      if (std::abs(truth_s[i] - at_s) < std::abs(truth_s[nearest] - at_s)) nearest = i;
    const double off_s = truth_s.empty() ? 1 : at_s - truth_s[nearest];
    if (std::abs(off_s) > kSame_s) {
      ++score.wrong;
      continue;
    }
    score.doubled += ++times[nearest] > 1;
    score.worst_ms = std::max(score.worst_ms, 1e3 * std::abs(off_s));
    score.mean_ms += 1e3 * off_s;
    ++found;
  }
  for (const int n : times) score.missed += n == 0;
  if (found > 0) score.mean_ms /= found;
  return score;
}

}  // namespace facenav::testing
