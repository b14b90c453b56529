#include "xdf/xdf_file.h"

#include <cmath>
#include <fstream>
#include <pugixml.hpp>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "xdf/xdf_bytes.h"

namespace facenav::steps {
namespace {

constexpr const char* kMagic = "XDF:";
constexpr std::uint16_t kStreamHeader = 2, kSamples = 3, kClockOffset = 4;
constexpr std::uint64_t kMostChunk = 256u << 20, kMostTexts = 64u << 20, kMostSamples = 250'000'000;
constexpr std::size_t kMostStreams = 1000;
constexpr int kMostChannels = 4096;
constexpr double kFastest_hz = 1e6;

struct Format {
  const char* name;
  int bytes;
};
constexpr Format kFormats[] = {{"int8", 1},  {"int16", 2},   {"int32", 4},
                               {"int64", 8}, {"float32", 4}, {"double64", 8}};

/// Bytes of a sample's number; 0 for text and unknown formats.
int bytesOf(const std::string& format) {
  for (const auto& each : kFormats)
    if (format == each.name) return each.bytes;
  return 0;
}

/// The next chunk's length, from the stream; false at the end, or within it.
bool readLength(std::istream& file, std::uint64_t& length) {
  char size = 0;
  if (!file.get(size) || (size != 1 && size != 4 && size != 8)) return false;
  char bytes[8] = {};
  if (!file.read(bytes, size)) return false;
  std::memcpy(&length, bytes, sizeof length);  // the rest is zero
  return true;
}

double takeNumber(XdfBytes& bytes, const std::string& format) {
  if (format == "float32") return bytes.take<float>();
  if (format == "double64") return bytes.take<double>();
  if (format == "int8") return bytes.take<std::int8_t>();
  if (format == "int16") return bytes.take<std::int16_t>();
  if (format == "int32") return bytes.take<std::int32_t>();
  return double(bytes.take<std::int64_t>());
}

/// Stamp of the next sample; NaN: it has none.
double takeStamp(XdfBytes& bytes) {
  const auto size = bytes.take<std::uint8_t>();
  if (size == 8) return bytes.take<double>();
  if (size != 0) bytes.skip(bytes.left() + 1);  // damaged
  return std::nan("");
}

/// False for a stamp soon after the last one that is kept and where the rate would have it: a recorder may
/// stamp every sample.
bool tellsMore(const XdfSeries& series, double stamp_s, double rate_hz) {
  constexpr double kNear_s = 0.02, kSoon_s = 0.02;
  if (series.stamps.empty()) return true;
  const auto& last = series.stamps.back();
  const double passed_s = double(series.values.size() - last.index) / rate_hz;
  return passed_s >= kSoon_s || std::abs(stamp_s - last.stamp_s - passed_s) > kNear_s;
}

std::string textAt(const pugi::xml_node& node, const char* name) {
  return node.child(name).text().as_string();
}

}  // namespace

bool XdfFile::isXdf(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  char magic[4] = {};
  return file.read(magic, 4) && std::string(magic, 4) == kMagic;
}

XdfFile::XdfFile(const std::filesystem::path& path) : path_(path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw Error("cannot be read", path.string(), "check its name");
  char magic[4] = {};
  if (!file.read(magic, 4) || std::string(magic, 4) != kMagic)
    throw Error("is no XDF recording", path.string(), "give a file of LabRecorder");
  const std::uint64_t whole = std::filesystem::file_size(path);
  for (std::uint64_t at = 4; at < whole;) {
    std::uint64_t length = 0;
    const bool has_length = readLength(file, length);
    const std::uint64_t begin = has_length ? std::uint64_t(file.tellg()) : whole;
    if (!has_length || length < 2 || length > kMostChunk || length > whole - begin) {
      damage_ = formatted("is damaged or cut short at byte %llu", static_cast<unsigned long long>(at));
      break;
    }
    std::uint16_t tag = 0;
    file.read(reinterpret_cast<char*>(&tag), sizeof tag);
    if (tag == kStreamHeader || tag == kSamples || tag == kClockOffset) read(file, tag, length - 2);
    at = begin + length;
    file.seekg(std::streamoff(at));
  }
  if (streams_.empty())
    throw Error(damage_.empty() ? "has no streams" : damage_ + ", before any stream", path.string(),
                "record it again, or copy it again");
}

XdfStream* XdfFile::find(std::uint32_t id) {
  for (auto& stream : streams_)
    if (stream.id == id) return &stream;
  return nullptr;
}

/// Reads a chunk's content, which begins with the stream's number. Samples of numbers are left in the file.
void XdfFile::read(std::istream& file, std::uint16_t tag, std::uint64_t size) {
  const auto place = std::uint64_t(file.tellg());
  std::uint32_t id = 0;
  if (size < sizeof id || !file.read(reinterpret_cast<char*>(&id), sizeof id)) return;
  XdfStream* stream = find(id);
  if (tag == kSamples && stream && !stream->isText()) {
    stream->chunks.emplace_back(place, size);
    return;
  }
  if (!stream && tag != kStreamHeader) return;
  std::string content(std::size_t(size - sizeof id), '\0');
  file.read(content.data(), std::streamsize(content.size()));
  if (tag == kStreamHeader) return takeHeader(id, content);
  if (tag == kSamples) return takeTexts(*stream, content);
  XdfBytes bytes(content);
  const double at_s = bytes.take<double>(), value_s = bytes.take<double>();
  if (bytes.isGood() && isUsableNumber(at_s) && isUsableNumber(value_s))
    stream->offsets.push_back({at_s, value_s});
}

void XdfFile::takeHeader(std::uint32_t id, const std::string& xml) {
  pugi::xml_document document;
  if (!document.load_buffer(xml.data(), xml.size()) || find(id) || streams_.size() >= kMostStreams) return;
  const auto info = document.child("info");
  XdfStream stream;
  stream.id = id;
  stream.name = textAt(info, "name");
  stream.type = textAt(info, "type");
  stream.format = textAt(info, "channel_format");
  const auto channels = numberIn(textAt(info, "channel_count")),
             rate = numberIn(textAt(info, "nominal_srate"));
  const bool is_usable = channels && *channels >= 1 && *channels <= kMostChannels && rate && *rate >= 0 &&
                         *rate <= kFastest_hz && (stream.isText() || bytesOf(stream.format) > 0);
  if (!is_usable) return;
  stream.channel_count = int(*channels);
  stream.rate_hz = *rate;
  for (const auto& channel : info.child("desc").child("channels").children("channel"))
    if (int(stream.channels.size()) < stream.channel_count)
      stream.channels.push_back({textAt(channel, "label"), textAt(channel, "unit"), textAt(channel, "type")});
  streams_.push_back(std::move(stream));
}

void XdfFile::takeTexts(XdfStream& stream, const std::string& content) {
  held_bytes_ += content.size();
  if (held_bytes_ > kMostTexts)
    throw Error("has more than 64 MB of markers", path_.string(), "record fewer streams of text");
  XdfBytes bytes(content);
  const auto count = bytes.takeLength();
  double stamp_s = stream.texts.empty() ? 0 : stream.texts.back().stamp_s;
  for (std::uint64_t i = 0; i < count && bytes.isGood(); ++i) {
    const double given_s = takeStamp(bytes);
    stamp_s = std::isnan(given_s) ? stamp_s + (stream.rate_hz > 0 ? 1 / stream.rate_hz : 0) : given_s;
    std::string first = bytes.takeText(bytes.takeLength());
    for (int channel = 1; channel < stream.channel_count; ++channel) bytes.skip(bytes.takeLength());
    if (bytes.isGood() && isUsableNumber(stamp_s)) stream.texts.push_back({stamp_s, std::move(first)});
  }
  if (!bytes.isGood() && damage_.empty()) damage_ = "has damaged samples in stream '" + stream.name + "'";
}

XdfSeries XdfFile::series(const XdfStream& stream, int channel) const {
  std::ifstream file(path_, std::ios::binary);
  XdfSeries series;
  std::string content;
  const std::uint64_t before = std::uint64_t(channel) * std::uint64_t(bytesOf(stream.format));
  const std::uint64_t after =
      std::uint64_t(stream.channel_count - channel - 1) * std::uint64_t(bytesOf(stream.format));
  for (const auto& [place, size] : stream.chunks) {
    content.resize(std::size_t(size));
    file.seekg(std::streamoff(place));
    if (!file.read(content.data(), std::streamsize(size)))
      throw Error("cannot be read any more", path_.string(), "check the disk");
    XdfBytes bytes(content);
    bytes.take<std::uint32_t>();
    const auto count = bytes.takeLength();
    for (std::uint64_t i = 0; i < count; ++i) {
      const double stamp_s = takeStamp(bytes);
      bytes.skip(before);
      const double value = takeNumber(bytes, stream.format);
      bytes.skip(after);
      if (!bytes.isGood())
        throw Error("has damaged samples in stream '" + stream.name + "'", path_.string(),
                    "copy or record it again");
      if (isUsableNumber(stamp_s) && tellsMore(series, stamp_s, stream.rate_hz))
        series.stamps.push_back({series.values.size(), stamp_s});
      series.values.push_back(float(value));
    }
    if (series.values.size() > kMostSamples)
      throw Error("stream '" + stream.name + "' has more than 250 million samples", path_.string(),
                  "record each session in a file of its own");
  }
  return series;
}

}  // namespace facenav::steps
