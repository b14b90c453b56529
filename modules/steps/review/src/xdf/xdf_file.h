#pragma once
// XdfFile: a recording of LSL streams (.xdf, version 1.0, as LabRecorder writes it). Streams of text are read
// whole, those of numbers only when asked for, one channel at a time. A file that ends within a chunk, as
// after a crash, is used up to there. Source: the XDF 1.0 specification (sccn/xdf, wiki).

#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

namespace facenav::steps {

struct XdfChannel {
  std::string label, unit, type;
};

struct XdfText {
  double stamp_s = 0;  // on the stream's own clock
  std::string text;    // of its first channel
};

struct XdfClockOffset {
  double at_s = 0, value_s = 0;  // the recorder's clock = the stream's clock + value
};

struct XdfStream {
  std::uint32_t id = 0;
  std::string name, type, format;  // format: "float32", "string", ..
  double rate_hz = 0;              // 0: irregular
  int channel_count = 0;
  std::vector<XdfChannel> channels;  // as many as are described
  std::vector<XdfText> texts;
  std::vector<XdfClockOffset> offsets;
  std::vector<std::pair<std::uint64_t, std::uint64_t>> chunks;  // of numbers: place and size in the file

  bool isText() const { return format == "string"; }
};

/// Holds one channel of a stream. A sample without a stamp follows the one before it at the stream's rate.
struct XdfSeries {
  std::vector<float> values;
  struct Stamp {
    std::uint64_t index;
    double stamp_s;
  };
  std::vector<Stamp> stamps;  // as they stand in the file, at most some 50 a second
};

class XdfFile {
 public:
  /// Reads headers, texts and clock offsets. Throws Error: no such file, no XDF, or nothing usable in it.
  explicit XdfFile(const std::filesystem::path& path);

  const std::vector<XdfStream>& streams() const { return streams_; }
  /// Reads one channel of a stream of numbers with a rate. Throws Error: damaged samples, or too many.
  XdfSeries series(const XdfStream& stream, int channel) const;
  /// Where the file is cut short or damaged, in words; empty: it is whole.
  const std::string& damage() const { return damage_; }
  /// True for a file that begins as an XDF.
  static bool isXdf(const std::filesystem::path& path);

 private:
  void read(std::istream& file, std::uint16_t tag, std::uint64_t size);
  void takeHeader(std::uint32_t id, const std::string& xml);
  void takeTexts(XdfStream& stream, const std::string& content);
  XdfStream* find(std::uint32_t id);

  std::filesystem::path path_;
  std::vector<XdfStream> streams_;
  std::string damage_;
  std::uint64_t held_bytes_ = 0;  // of texts
};

}  // namespace facenav::steps
