#include "facenav/sounds/tones.h"

#include <algorithm>
#include <cmath>

namespace facenav::sounds {
namespace {

struct Note {
  double hz, length_s;
};

constexpr double kFade_s = 0.005;  // without it, each note would begin and end with a click
constexpr double kLoudest = 0.5 * 32767;

std::vector<Note> notesOf(Tone tone) {
  switch (tone) {
    case Tone::lost:
      return {{440, 0.18}, {220, 0.25}};
    case Tone::approaching:
      return {{660, 0.09}};
    case Tone::on_target:
      return {{880, 0.09}, {1320, 0.16}};
    case Tone::pulse:
      return {{2000, 0.02}};
  }
  return {};
}

/// Fade factor, a raised cosine at both ends.
double fadeAt(double t_s, double length_s) {
  const double from_end_s = std::min({t_s, length_s - t_s, kFade_s});
  return 0.5 - 0.5 * std::cos(M_PI * from_end_s / kFade_s);
}

}  // namespace

std::vector<std::int16_t> samplesOf(Tone tone, double volume) {
  const double loudness = kLoudest * std::clamp(volume, 0.0, 1.0);
  std::vector<std::int16_t> samples;
  for (const Note& note : notesOf(tone)) {
    const int count = int(std::lround(note.length_s * kSamplesPerSecond));
    for (int i = 0; i < count; ++i) {
      const double t_s = double(i) / kSamplesPerSecond;
      const double value =
          loudness * fadeAt(t_s, double(count - 1) / kSamplesPerSecond) * std::sin(2 * M_PI * note.hz * t_s);
      samples.push_back(std::int16_t(std::lround(value)));
    }
  }
  return samples;
}

}  // namespace facenav::sounds
