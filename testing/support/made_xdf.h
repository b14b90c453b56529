#pragma once
// Writes XDF recordings for tests, by the specification of XDF 1.0, byte by byte.

#include <cstdint>
#include <cstring>
#include <optional>
#include <string>

namespace facenav::testing {

class MadeXdf {
 public:
  MadeXdf() { chunk(1, R"(<?xml version="1.0"?><info><version>1.0</version></info>)"); }

  /// Adds a stream; `desc`: XML of its description.
  void stream(std::uint32_t id, const std::string& name, const std::string& type, int channels,
              double rate_hz, const std::string& format, const std::string& desc = "") {
    chunk(2, number(id) + "<?xml version=\"1.0\"?><info><name>" + name + "</name><type>" + type +
                 "</type><channel_count>" + std::to_string(channels) + "</channel_count><nominal_srate>" +
                 std::to_string(rate_hz) + "</nominal_srate><channel_format>" + format +
                 "</channel_format><desc>" + desc + "</desc></info>");
  }
  static std::string channel(const std::string& label, const std::string& unit, const std::string& type) {
    return "<channel><label>" + label + "</label><unit>" + unit + "</unit><type>" + type +
           "</type></channel>";
  }
  void text(std::uint32_t id, double stamp_s, const std::string& text) {
    chunk(3, number(id) + '\1' + '\1' + '\10' + number(stamp_s) + '\4' + number(std::uint32_t(text.size())) +
                 text);
  }
  /// Begins a chunk of numeric samples; finish it with endSamples().
  void beginSamples(std::uint32_t id) {
    id_ = id;
    count_ = 0;
    samples_.clear();
  }
  template <class Number>
  void sample(std::optional<double> stamp_s, std::initializer_list<Number> values) {
    samples_ += stamp_s ? '\10' + number(*stamp_s) : std::string(1, '\0');
    for (const Number value : values) samples_ += number(value);
    ++count_;
  }
  void endSamples() { chunk(3, number(id_) + '\4' + number(count_) + samples_); }
  void offset(std::uint32_t id, double at_s, double value_s) {
    chunk(4, number(id) + number(at_s) + number(value_s));
  }
  void chunk(std::uint16_t tag, const std::string& content) {
    bytes += '\10' + number(std::uint64_t(content.size() + 2)) + number(tag) + content;
  }
  template <class Number>
  static std::string number(Number value) {
    std::string text(sizeof value, '\0');
    std::memcpy(text.data(), &value, sizeof value);
    return text;
  }

  std::string bytes = "XDF:";

 private:
  std::uint32_t id_ = 0, count_ = 0;
  std::string samples_;
};

/// Markers "T" at two times, and EMG at 1000 Hz that goes up and down by 120 uV from 50 ms before the first
/// to 100 ms after the second.
inline std::string twoPulsesXdf(double first_s, double second_s) {
  MadeXdf xdf;
  xdf.stream(3, "Pulses", "Markers", 1, 0, "string");
  xdf.stream(7, "Amplifier", "EMG", 1, 1000, "int16",
             "<channels>" + MadeXdf::channel("FDI", "uV", "EMG") + "</channels>");
  for (const double at_s : {first_s, second_s}) xdf.text(3, at_s, "T");
  xdf.beginSamples(7);
  for (int i = 0; i < int(1000 * (second_s - first_s + 0.15)); ++i)
    xdf.sample<std::int16_t>(i == 0 ? std::optional(first_s - 0.05) : std::nullopt,
                             {std::int16_t(i % 2 ? 60 : -60)});
  xdf.endSamples();
  return xdf.bytes;
}

}  // namespace facenav::testing
