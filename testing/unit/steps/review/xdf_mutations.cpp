// Reads damaged XDF recordings under the address and undefined-behaviour sanitizers:
//   xdf_mutations FILE [COUNT] [SEED]    FILE: written over

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <random>

#include "facenav/core/error.h"
#include "support/made_xdf.h"
#include "xdf/xdf_clock.h"

namespace {

std::string smallRecording() {
  facenav::testing::MadeXdf xdf;
  xdf.stream(3, "Pulses", "Markers", 1, 0, "string");
  xdf.stream(7, "Amplifier", "EMG", 2, 1000, "int16",
             "<channels>" + facenav::testing::MadeXdf::channel("FDI", "uV", "EMG") + "</channels>");
  for (int i = 0; i < 5; ++i) {
    xdf.text(3, 10 + i, "T");
    xdf.offset(7, 10 + i, 0.5);
    xdf.beginSamples(7);
    for (int k = 0; k < 100; ++k)
      xdf.sample<std::int16_t>(k == 0 ? std::optional(10.0 + i) : std::nullopt,
                               {std::int16_t(k), std::int16_t(i)});
    xdf.endSamples();
  }
  return xdf.bytes;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  const int count = argc > 2 ? std::atoi(argv[2]) : 20000;
  std::mt19937 random(argc > 3 ? unsigned(std::atoi(argv[3])) : 1);
  const std::string whole = smallRecording();
  long read = 0, refused = 0, samples = 0;
  for (int n = 0; n < count; ++n) {
    std::string bytes = whole;
    for (unsigned i = 1 + random() % 4; i > 0; --i) {
      const std::size_t at = random() % bytes.size();
      if (random() % 8 == 0)
        bytes.resize(std::max<std::size_t>(at, 1));
      else
        bytes[at] = char(random());
    }
    std::ofstream(argv[1], std::ios::binary) << bytes;
    try {
      const facenav::steps::XdfFile file(argv[1]);
      for (const auto& stream : file.streams()) {
        if (stream.isText() || !(stream.rate_hz > 0)) continue;
        const auto series = file.series(stream, stream.channel_count - 1);
        const facenav::steps::XdfTimes times(series, stream.rate_hz,
                                             facenav::steps::XdfClock(stream.offsets));
        samples += times.within(10.01, 10.05) ? long(series.values.size()) : 0;
      }
      ++read;
    } catch (const facenav::Error&) {
      ++refused;
    }
  }
  std::printf("%d damaged recordings: %ld read, %ld refused, %ld samples\n", count, read, refused, samples);
}
