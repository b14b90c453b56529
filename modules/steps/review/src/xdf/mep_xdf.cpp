#include "xdf/mep_xdf.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/core/utc_time.h"
#include "xdf/xdf_clock.h"

namespace facenav::steps {
namespace {

constexpr std::size_t kLeastSamples = 15;  // in the window; fewer miss an MEP's peaks
constexpr std::size_t kMostNamed = 6;      // in a message
constexpr const char* kOwnStream = "FaceNav";

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& what,
                         const std::string& remedy) {
  throw Error(what, path.filename().string(), remedy);
}

std::string lowered(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

/// "A:B" in its two parts; the second may be empty.
std::pair<std::string, std::string> partsOf(const std::string& words) {
  const auto colon = words.find(':');
  return {words.substr(0, colon), colon == std::string::npos ? "" : words.substr(colon + 1)};
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size() && i < kMostNamed; ++i) text += (i > 0 ? ", " : "") + names[i];
  return names.size() > kMostNamed ? text + ", .." : text;
}

bool hasEmg(const XdfStream& stream) {
  return lowered(stream.type) == "emg" ||
         std::any_of(stream.channels.begin(), stream.channels.end(),
                     [](const auto& channel) { return lowered(channel.type) == "emg"; });
}

const XdfStream& emgStream(const XdfFile& file, const std::filesystem::path& path, const std::string& name) {
  std::vector<const XdfStream*> fitting;
  std::vector<std::string> names;
  for (const auto& stream : file.streams()) {
    if (stream.isText()) continue;
    names.push_back(stream.name);
    if (name.empty() ? hasEmg(stream) : stream.name == name) fitting.push_back(&stream);
  }
  if (fitting.size() != 1)
    refuse(path,
           (fitting.empty() ? "has no EMG" : "has several streams of EMG") +
               (name.empty() ? std::string() : " named '" + name + "'") + "; its streams: " + listed(names),
           "name it: --emg STREAM:CHANNEL");
  if (!(fitting[0]->rate_hz > 0))
    refuse(path, "the stream '" + fitting[0]->name + "' has no rate", "name another: --emg STREAM:CHANNEL");
  return *fitting[0];
}

int emgChannel(const XdfStream& stream, const std::filesystem::path& path, const std::string& name) {
  if (const auto number = numberIn(name);
      number && *number >= 1 && *number <= stream.channel_count && *number == std::floor(*number))
    return int(*number) - 1;
  std::vector<int> fitting;
  std::vector<std::string> names;
  for (int i = 0; i < int(stream.channels.size()); ++i) {
    const auto& channel = stream.channels[std::size_t(i)];
    names.push_back(channel.label);
    if (name.empty() ? lowered(channel.type) == "emg" : channel.label == name) fitting.push_back(i);
  }
  if (name.empty() && stream.channel_count == 1) return 0;
  if (fitting.size() == 1) return fitting[0];
  refuse(path,
         formatted("the stream '%s' has %d channels", stream.name.c_str(), stream.channel_count) +
             (names.empty() ? "" : ": " + listed(names)),
         "name one: --emg " + stream.name + ":CHANNEL, by its label or number");
}

/// Microvolts of a unit as people and programs write it; nothing for other words.
std::optional<double> microvoltsOf(const std::string& unit) {
  static const std::map<std::string, double> known{{"uv", 1},          {"\u00b5v", 1},      {"\u03bcv", 1},
                                                   {"microvolt", 1},   {"microvolts", 1},   {"mv", 1e3},
                                                   {"millivolt", 1e3}, {"millivolts", 1e3}, {"v", 1e6},
                                                   {"volt", 1e6},      {"volts", 1e6}};
  const auto found = known.find(lowered(unit));
  return found == known.end() ? std::nullopt : std::optional(found->second);
}

double unitOf(const XdfStream& stream, int channel, const std::filesystem::path& path,
              const std::string& given) {
  std::string said;
  if (channel < int(stream.channels.size())) said = stream.channels[std::size_t(channel)].unit;
  const auto factor = microvoltsOf(given.empty() ? said : given);
  if (factor) return *factor;
  refuse(path,
         said.empty() ? "the EMG '" + stream.name + "' does not say its unit"
                      : "the EMG's unit '" + said + "' is not known",
         "give it: --emg-unit uV, mV or V");
}

struct Marker {
  double at_s = 0;                  // on the recorder's clock
  std::optional<double> session_s;  // seconds since 1970, as FaceNav sent it
  int number = 0;                   // in its stream, from 1
};

/// Time of a pulse that FaceNav sent as JSON; nothing for other text.
std::optional<double> ownPulse(const std::string& text) {
  if (text.empty() || text[0] != '{' || text.size() > 4096) return std::nullopt;
  const auto json = nlohmann::json::parse(text, nullptr, false);
  if (!json.is_object()) return std::nullopt;
  const auto pulse = json.find("pulse"), utc = json.find("utc");
  if (pulse == json.end() || *pulse != true || utc == json.end() || !utc->is_string()) return std::nullopt;
  return secondsOfUtc(utc->get<std::string>());
}

std::vector<Marker> ownMarkers(const XdfStream& stream) {
  const XdfClock clock(stream.offsets);
  std::vector<Marker> markers;
  for (std::size_t i = 0; i < stream.texts.size(); ++i)
    if (const auto session_s = ownPulse(stream.texts[i].text))
      markers.push_back({clock.recorded_s(stream.texts[i].stamp_s), session_s, int(i) + 1});
  return markers;
}

/// Markers with this text; empty: the stream must have only one text.
std::vector<Marker> markersOf(const XdfStream& stream, const std::string& text,
                              const std::filesystem::path& path) {
  const XdfClock clock(stream.offsets);
  std::map<std::string, int> counts;
  std::vector<Marker> markers;
  for (std::size_t i = 0; i < stream.texts.size(); ++i) {
    ++counts[stream.texts[i].text];
    if (text.empty() || stream.texts[i].text == text)
      markers.push_back({clock.recorded_s(stream.texts[i].stamp_s), {}, int(i) + 1});
  }
  std::vector<std::string> names;
  for (const auto& [name, count] : counts)
    names.push_back(formatted("'%.40s' %d times", name.c_str(), count));
  if (text.empty() && counts.size() > 1)
    refuse(path, "the stream '" + stream.name + "' has several markers: " + listed(names),
           "name the pulse's: --markers " + stream.name + ":MARKER");
  if (markers.empty())
    refuse(path,
           "the stream '" + stream.name + "' has no such marker" +
               (names.empty() ? std::string() : "; it has " + listed(names)),
           "name another: --markers STREAM:MARKER");
  return markers;
}

/// The pulses' markers, and the name of their stream.
std::vector<Marker> pulseMarkers(const XdfFile& file, const std::filesystem::path& path,
                                 const std::string& words, std::string& stream_name) {
  const auto [name, text] = partsOf(words);
  std::vector<const XdfStream*> fitting;
  std::vector<std::string> names;
  for (const auto& stream : file.streams()) {
    if (!stream.isText()) continue;
    names.push_back(stream.name);
    if (name.empty() ? !stream.texts.empty() : stream.name == name) fitting.push_back(&stream);
    if (!text.empty() || !(name.empty() ? stream.name == kOwnStream : stream.name == name)) continue;
    if (auto own = ownMarkers(stream); !own.empty()) return stream_name = stream.name, own;
  }
  if (fitting.size() != 1)
    refuse(path,
           (fitting.empty() ? "has no such markers" : "has several streams of markers") +
               (names.empty() ? std::string() : ": " + listed(names)),
           "name the pulses': --markers STREAM:MARKER");
  stream_name = fitting[0]->name;
  return markersOf(*fitting[0], text, path);
}

/// Peak to peak of the samples; nothing if one is no number.
std::optional<double> peakToPeak(const std::vector<float>& values, std::uint64_t first, std::uint64_t last) {
  const auto begin = values.begin() + std::ptrdiff_t(first), end = values.begin() + std::ptrdiff_t(last);
  if (std::any_of(begin, end, [](float value) { return !std::isfinite(value); })) return std::nullopt;
  const auto [least, most] = std::minmax_element(begin, end);
  return double(*most) - double(*least);
}

void requireWindow(const XdfStream& stream, const MepImportLimits& limits,
                   const std::filesystem::path& path) {
  const double samples = stream.rate_hz * (limits.emg_to_ms - limits.emg_from_ms) / 1000;
  if (samples < double(kLeastSamples))
    refuse(path,
           formatted("the EMG '%s' has %.0f samples a second, too few for an MEP", stream.name.c_str(),
                     stream.rate_hz),
           "record it at 1000 or more");
}

}  // namespace

XdfChoice xdfChoiceFrom(const std::string& words) {
  std::vector<std::string> parts(1);
  for (const char c : words) {
    if (c == ';')
      parts.emplace_back();
    else
      parts.back() += c;
  }
  for (auto& part : parts) {
    part.erase(0, part.find_first_not_of(' '));
    part.erase(part.find_last_not_of(' ') + 1);
  }
  if (parts.size() > 3 || (parts.size() == 3 && !parts[2].empty() && !microvoltsOf(parts[2])))
    throw Error("'" + words + "' is not understood", {}, "type STREAM:CHANNEL; STREAM:MARKER; uV");
  parts.resize(3);
  return {parts[0], parts[1], parts[2]};
}

MepFile readXdfMeps(const std::filesystem::path& path, const XdfChoice& choice,
                    const MepImportLimits& limits) {
  const XdfFile file(path);
  const auto [stream_name, channel_name] = partsOf(choice.emg);
  const XdfStream& emg = emgStream(file, path, stream_name);
  requireWindow(emg, limits, path);
  const int channel = emgChannel(emg, path, channel_name);
  const double to_uv = unitOf(emg, channel, path, choice.unit);
  std::string markers_name;
  const auto markers = pulseMarkers(file, path, choice.markers, markers_name);
  const XdfSeries series = file.series(emg, channel);
  const XdfTimes times(series, emg.rate_hz, XdfClock(emg.offsets));
  MepFile meps;
  meps.name = path.filename().string();
  meps.is_utc = meps.is_own_clock = markers.front().session_s.has_value();
  meps.row_word = "marker";
  if (!file.damage().empty()) meps.notes.push_back("the file " + file.damage() + "; used up to there");
  int missing = 0;
  for (const auto& marker : markers) {
    const auto samples =
        times.within(marker.at_s + limits.emg_from_ms / 1000, marker.at_s + limits.emg_to_ms / 1000);
    const auto peaks = samples ? peakToPeak(series.values, samples->first, samples->second) : std::nullopt;
    const double mep_uv = peaks.value_or(-1) * to_uv;
    if (!peaks || mep_uv > casefile::kLargestMep_uv) {
      ++missing;
      continue;
    }
    meps.rows.push_back({marker.session_s.value_or(marker.at_s), mep_uv, {}, marker.number});
  }
  meps.notes.push_back(formatted("EMG '%s', channel %d, %.0f to %.0f ms after the %zu markers of '%s'",
                                 emg.name.c_str(), channel + 1, limits.emg_from_ms, limits.emg_to_ms,
                                 markers.size(), markers_name.c_str()));
  if (missing > 0)
    meps.notes.push_back(formatted("%d markers have no usable EMG after them: left out", missing));
  return meps;
}

}  // namespace facenav::steps
