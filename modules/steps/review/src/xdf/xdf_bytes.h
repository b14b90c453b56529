#pragma once
// XdfBytes: reads numbers and texts from a chunk of an XDF file, never past its end. All numbers are
// little-endian.

#include <cstdint>
#include <cstring>
#include <string>

namespace facenav::steps {

class XdfBytes {
 public:
  explicit XdfBytes(const std::string& bytes) : bytes_(bytes) {}

  std::size_t left() const { return bytes_.size() - at_; }
  /// True if everything read so far was there.
  bool isGood() const { return is_good_; }
  template <class Number>
  Number take() {
    Number number{};
    if (left() < sizeof number) return fail(), number;
    std::memcpy(&number, bytes_.data() + at_, sizeof number);
    at_ += sizeof number;
    return number;
  }
  /// A length: its own size (1, 4 or 8 bytes), then the number.
  std::uint64_t takeLength() {
    const auto size = take<std::uint8_t>();
    if (size == 1) return take<std::uint8_t>();
    if (size == 4) return take<std::uint32_t>();
    if (size == 8) return take<std::uint64_t>();
    fail();
    return 0;
  }
  std::string takeText(std::uint64_t size) {
    if (size > left()) return fail(), std::string();
    std::string text = bytes_.substr(at_, std::size_t(size));
    at_ += std::size_t(size);
    return text;
  }
  void skip(std::uint64_t size) {
    if (size > left()) return fail();
    at_ += std::size_t(size);
  }

 private:
  void fail() {
    is_good_ = false;
    at_ = bytes_.size();
  }

  const std::string& bytes_;
  std::size_t at_ = 0;
  bool is_good_ = true;
};

}  // namespace facenav::steps
