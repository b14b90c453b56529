#pragma once
// Numbers as big-endian bytes: a writer, and a reader that never reads past the end.

#include <cstring>
#include <string>

#include "facenav/links/igtl_message.h"

namespace facenav::links {

class BigEndianWriter {
 public:
  /// Adds the lowest `size` bytes of the number.
  void put(std::uint64_t number, int size) {
    for (int i = size - 1; i >= 0; --i) bytes.push_back(std::uint8_t(number >> (8 * i)));
  }
  void putFloat(double value) {
    const float rounded = float(value);
    std::uint32_t bits;
    std::memcpy(&bits, &rounded, sizeof bits);
    put(bits, 4);
  }
  /// Adds the text in a field of that size, filled up with zeros or cut.
  void putText(const std::string& text, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i) bytes.push_back(i < text.size() ? std::uint8_t(text[i]) : 0);
  }
  void putText(const std::string& text) { putText(text, text.size()); }

  Bytes bytes;
};

class BigEndianReader {
 public:
  BigEndianReader(const std::uint8_t* bytes, std::size_t size) : at_(bytes), left_(size) {}
  explicit BigEndianReader(const Bytes& bytes) : BigEndianReader(bytes.data(), bytes.size()) {}

  std::size_t left() const { return left_; }
  /// True if every value read so far was there.
  bool isGood() const { return is_good_; }
  std::uint64_t take(int size) {
    std::uint64_t number = 0;
    if (!has(std::size_t(size))) return 0;
    for (int i = 0; i < size; ++i) number = number << 8 | at_[i];
    move(std::size_t(size));
    return number;
  }
  float takeFloat() {
    const auto bits = std::uint32_t(take(4));
    float value;
    std::memcpy(&value, &bits, sizeof value);
    return value;
  }
  std::string takeText(std::size_t size) {
    if (!has(size)) return {};
    std::string text(reinterpret_cast<const char*>(at_), size);
    move(size);
    return text;
  }
  /// Takes a field of text that ends at its first zero.
  std::string takeName(std::size_t size) {
    std::string text = takeText(size);
    return text.substr(0, text.find('\0'));
  }
  Bytes takeBytes(std::size_t size) {
    if (!has(size)) return {};
    Bytes taken(at_, at_ + size);
    move(size);
    return taken;
  }

 private:
  bool has(std::size_t size) {
    is_good_ = is_good_ && left_ >= size;
    return is_good_;
  }
  void move(std::size_t size) { at_ += size, left_ -= size; }

  const std::uint8_t* at_;
  std::size_t left_;
  bool is_good_ = true;
};

}  // namespace facenav::links
