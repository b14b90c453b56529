#pragma once
// Seeded damage to good files: truncations, flipped bits, overwritten lengths.

#include <random>
#include <string>
#include <vector>

#include "dicom_bytes.h"

namespace facenav::testing {

inline std::string mutated(std::string bytes, std::mt19937& random) {
  const auto below = [&](std::size_t n) { return std::size_t(random()) % std::max<std::size_t>(1, n); };
  // Most of the damage goes to the header, where it has most effect.
  const std::size_t reach = below(4) ? std::min<std::size_t>(bytes.size(), 4096) : bytes.size();
  switch (below(5)) {
    case 0:
      bytes.resize(below(bytes.size()));
      break;
    case 1:
      for (std::size_t n = 1 + below(8); n-- > 0;) bytes[below(reach)] ^= char(1 << below(8));
      break;
    case 2:
      for (std::size_t n = 1 + below(8); n-- > 0;) bytes[below(reach)] = char(below(256));
      break;
    case 3: {
      const std::size_t at = below(reach);
      for (std::size_t i = at; i < std::min(bytes.size(), at + 4); ++i)
        bytes[i] = char(below(2) ? 0xFF : 0x00);
      break;
    }
    default: {
      const std::size_t at = below(reach), length = 1 + below(64);
      bytes.erase(at, length);
    }
  }
  return bytes;
}

/// Slices that all contain the encapsulated pixels of one real file, so that damage reaches the codecs.
inline std::vector<std::string> compressedSlices(const std::string& file, Slice first,
                                                 const std::string& syntax, int count) {
  const std::size_t at = file.rfind(std::string("\xE0\x7F\x10\0O", 5));
  std::vector<std::string> files;
  if (at == std::string::npos) return files;
  first.syntax.uid = syntax;
  for (const Slice& s : makeSlices(count, first))
    files.push_back(fileOf(headerOf(s).raw(0x7FE00010, "OB", file.substr(at + 12), true)));
  return files;
}

}  // namespace facenav::testing
