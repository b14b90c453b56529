#pragma once
// Tones: the sounds of a treatment as PCM samples. They differ in pitch, direction and length, so that they
// can be distinguished without a musical ear: lost falls, on target rises, approaching is one short tone
// between them, a pulse is a click.

#include <cstdint>
#include <vector>

namespace facenav::sounds {

enum class Tone { lost, approaching, on_target, pulse };

constexpr int kSamplesPerSecond = 44100;

/// Samples of a tone: mono, 16 bit. `volume` 0..1 (clamped): 1 is half of full scale, since a pure tone at
/// full scale hurts.
std::vector<std::int16_t> samplesOf(Tone tone, double volume);

}  // namespace facenav::sounds
