#include <thread>

#include "facenav/core/error.h"
#include "sound_input.h"

#ifdef FACENAV_HAS_SNDFILE
#include <sndfile.h>
#endif

namespace facenav::links {

void SampleClock::note(std::int64_t count, Timestamp at) {
  constexpr double kDrift = 1e-4;  // largest drift of the card's clock; some 20 ppm are usual
  const double offset_s = at.s - double(count) / samples_per_s_;
  if (!is_known_ || offset_s < offset_s_)
    offset_s_ = offset_s;
  else
    offset_s_ = std::min(offset_s, offset_s_ + kDrift * (at - noted_));
  is_known_ = true;
  noted_ = at;
}

#ifdef FACENAV_HAS_SNDFILE
namespace {

constexpr double kBlock_s = 0.005;

class SoundFile : public SoundInput {
 public:
  explicit SoundFile(const std::string& path) : file_(sf_open(path.c_str(), SFM_READ, &info_)) {
    if (!file_)
      throw Error(std::string("the sound cannot be read (") + sf_strerror(nullptr) + ")", path,
                  "a WAV or FLAC file is expected");
    begin_ = Timestamp::now();
  }
  ~SoundFile() override { sf_close(file_); }
  SoundFile(const SoundFile&) = delete;
  SoundFile& operator=(const SoundFile&) = delete;
  double samplesPerSecond() const override { return info_.samplerate; }
  Timestamp timeOf(std::int64_t sample) const override {
    return {begin_.s + double(sample) / info_.samplerate};
  }

  Heard read(std::vector<float>& samples, int wait_ms) override {
    const auto count = sf_count_t(kBlock_s * info_.samplerate) + 1;
    const double early_s = timeOf(read_ + count).s - Timestamp::now().s;
    if (early_s > 1e-3 * wait_ms) {
      std::this_thread::sleep_for(std::chrono::milliseconds(wait_ms));
      return Heard::nothing_yet;
    }
    if (early_s > 0) std::this_thread::sleep_for(std::chrono::duration<double>(early_s));
    std::vector<float> all(std::size_t(count * info_.channels));
    const auto got = sf_readf_float(file_, all.data(), count);
    if (got <= 0) return Heard::end;
    samples.resize(std::size_t(got));
    for (std::size_t i = 0; i < samples.size(); ++i) {
      samples[i] = 0;
      for (int c = 0; c < info_.channels; ++c)
        samples[i] += all[i * std::size_t(info_.channels) + std::size_t(c)] / float(info_.channels);
    }
    read_ += got;
    return Heard::samples;
  }

 private:
  SF_INFO info_{};
  SNDFILE* file_;
  Timestamp begin_;
  std::int64_t read_ = 0;
};

}  // namespace

std::unique_ptr<SoundInput> openSoundFile(const std::string& path) {
  return std::make_unique<SoundFile>(path);
}
#else
std::unique_ptr<SoundInput> openSoundFile(const std::string& path) {
  throw Error("FaceNav was built without libsndfile: no sound file can be played", path,
              "install libsndfile1-dev and build again");
}
#endif

}  // namespace facenav::links
