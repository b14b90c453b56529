#include "codestream_size.h"

#include <cstdint>

namespace facenav::dicom {
namespace {

std::uint32_t bigEndian(std::string_view s, std::size_t at, int bytes) {
  std::uint32_t value = 0;
  for (int b = 0; b < bytes; ++b) value = value << 8 | static_cast<unsigned char>(s[at + b]);
  return value;
}

bool isFrameHeader(unsigned marker) {
  if (marker == 0xFFF7) return true;  // JPEG-LS
  return marker >= 0xFFC0 && marker <= 0xFFCF && marker != 0xFFC4 && marker != 0xFFC8 && marker != 0xFFCC;
}

}  // namespace

std::optional<CodestreamSize> jpegSize(std::string_view s) {
  if (s.size() < 4 || bigEndian(s, 0, 2) != 0xFFD8) return std::nullopt;
  std::size_t at = 2;
  while (at + 10 <= s.size()) {
    const unsigned marker = bigEndian(s, at, 2);
    if (marker == 0xFFFF) {  // fill byte
      ++at;
      continue;
    }
    if (marker < 0xFF01) return std::nullopt;
    if (isFrameHeader(marker))
      return CodestreamSize{long(bigEndian(s, at + 7, 2)), long(bigEndian(s, at + 5, 2)),
                            long(bigEndian(s, at + 9, 1))};
    at += 2 + bigEndian(s, at + 2, 2);
  }
  return std::nullopt;
}

std::optional<CodestreamSize> jpeg2000Size(std::string_view s) {
  const std::size_t start = s.substr(0, 4096).find("\xFF\x4F\xFF\x51");
  if (start == std::string_view::npos || start + 45 > s.size()) return std::nullopt;
  const std::size_t siz = start + 6;  // Rsiz
  const long components = long(bigEndian(s, siz + 34, 2));
  const bool is_full_resolution = s[siz + 37] == 1 && s[siz + 38] == 1;
  const auto extent = [&](std::size_t size, std::size_t origin) {
    return long(bigEndian(s, siz + size, 4)) - long(bigEndian(s, siz + origin, 4));
  };
  const CodestreamSize found{extent(2, 10), extent(6, 14), components};
  const long tile_width = long(bigEndian(s, siz + 18, 4)), tile_height = long(bigEndian(s, siz + 22, 4));
  if (!is_full_resolution || found.width < 1 || found.height < 1 || tile_width < 1 || tile_height < 1)
    return std::nullopt;
  const long tiles = ((found.width - 1) / tile_width + 1) * ((found.height - 1) / tile_height + 1);
  return tiles > 65535 ? std::nullopt : std::optional<CodestreamSize>(found);
}

}  // namespace facenav::dicom
