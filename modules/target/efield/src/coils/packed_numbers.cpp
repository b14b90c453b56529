#include "packed_numbers.h"

#include <zlib.h>

#include <cstdint>
#include <cstring>

namespace facenav::efield {
namespace {

constexpr std::size_t kMostBytes = std::size_t(1) << 30;

int digitOf(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  return c == '+' ? 62 : c == '/' ? 63 : -1;
}

/// The bytes of a zlib stream; nothing if it is damaged or endless.
std::optional<std::string> inflated(const std::string& packed) {
  z_stream stream{};
  if (inflateInit(&stream) != Z_OK) return std::nullopt;
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = uInt(packed.size());
  std::string bytes;
  std::vector<char> part(1 << 16);
  int state = Z_OK;
  while (state == Z_OK && bytes.size() < kMostBytes) {
    stream.next_out = reinterpret_cast<Bytef*>(part.data());
    stream.avail_out = uInt(part.size());
    state = inflate(&stream, Z_NO_FLUSH);
    bytes.append(part.data(), part.size() - stream.avail_out);
  }
  inflateEnd(&stream);
  if (state != Z_STREAM_END) return std::nullopt;
  return bytes;
}

}  // namespace

std::optional<std::string> bytesOfBase64(const std::string& text) {
  std::string bytes;
  std::uint32_t bits = 0;
  int held = 0, digits = 0, padding = 0;
  for (const char c : text) {
    if (c == ' ' || c == '\n' || c == '\r' || c == '\t') continue;
    ++digits;
    if (c == '=') {
      ++padding;
      continue;
    }
    const int digit = digitOf(c);
    if (digit < 0 || padding > 0) return std::nullopt;
    bits = (bits << 6) | std::uint32_t(digit);
    held += 6;
    if (held < 8) continue;
    held -= 8;
    bytes += char((bits >> held) & 0xFF);
  }
  if (digits % 4 != 0 || padding > 2) return std::nullopt;
  return bytes;
}

std::optional<std::vector<double>> unpackedNumbers(const std::string& text) {
  auto bytes = bytesOfBase64(text);
  if (!bytes) return std::nullopt;
  if (auto unpacked = inflated(*bytes)) bytes = std::move(unpacked);
  if (bytes->empty() || bytes->size() % sizeof(double) != 0) return std::nullopt;
  std::vector<double> numbers(bytes->size() / sizeof(double));
  std::memcpy(numbers.data(), bytes->data(), bytes->size());
  return numbers;
}

}  // namespace facenav::efield
