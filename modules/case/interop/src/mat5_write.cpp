#include <cstdint>
#include <cstring>

#include "facenav/core/error.h"
#include "mat5.h"

namespace facenav::interop {
namespace {

constexpr std::uint32_t kInt8 = 1, kUint16 = 4, kInt32 = 5, kUint32 = 6, kDouble = 9, kMatrix = 14;
constexpr std::uint32_t kCellClass = 1, kStructClass = 2, kCharClass = 4, kDoubleClass = 6;
constexpr std::size_t kFieldLength = 32;  // bytes of a field's name with its end

template <class T>
std::string bytesOf(const std::vector<T>& values) {
  std::string bytes(values.size() * sizeof(T), '\0');
  if (!values.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
  return bytes;
}

std::string element(std::uint32_t type, std::string bytes) {
  std::string result = bytesOf<std::uint32_t>({type, std::uint32_t(bytes.size())});
  bytes.resize((bytes.size() + 7) / 8 * 8, '\0');
  return result + bytes;
}

/// UTF-16 code units of text in UTF-8.
std::vector<std::uint16_t> utf16Of(const std::string& text) {
  std::vector<std::uint16_t> units;
  for (std::size_t i = 0; i < text.size();) {
    const auto lead = std::uint8_t(text[i]);
    const int length = lead < 0x80 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
    std::uint32_t code = length == 1 ? lead : lead & (0xFF >> (length + 1));
    for (int k = 1; k < length && i + std::size_t(k) < text.size(); ++k)
      code = (code << 6) | (std::uint8_t(text[i + std::size_t(k)]) & 0x3F);
    i += std::size_t(length);
    if (code >= 0x10000) {
      units.push_back(std::uint16_t(0xD800 + ((code - 0x10000) >> 10)));
      units.push_back(std::uint16_t(0xDC00 + ((code - 0x10000) & 0x3FF)));
    } else {
      units.push_back(std::uint16_t(code));
    }
  }
  return units;
}

std::string headOf(std::uint32_t array_class, const std::vector<std::int32_t>& size,
                   const std::string& name) {
  return element(kUint32, bytesOf<std::uint32_t>({array_class, 0})) + element(kInt32, bytesOf(size)) +
         element(kInt8, name);
}

std::string matrixOf(const MatValue& value, const std::string& name);

std::string structureOf(const MatValue& value, const std::string& name) {
  std::string names;
  for (std::string field : value.fields) {
    field.resize(kFieldLength, '\0');
    names += field;
  }
  // The length of the names stands in its tag, as readers expect it.
  std::string bytes = headOf(kStructClass, {1, std::int32_t(value.elements.size())}, name) +
                      bytesOf<std::uint32_t>({kInt32 | (4u << 16), kFieldLength}) + element(kInt8, names);
  for (const auto& fields : value.elements)
    for (const auto& field : value.fields) bytes += matrixOf(fields.at(field), "");
  return bytes;
}

std::string matrixOf(const MatValue& value, const std::string& name) {
  switch (value.type) {
    case MatValue::Type::text: {
      const auto units = utf16Of(value.text);
      return element(kMatrix, headOf(kCharClass, {units.empty() ? 0 : 1, std::int32_t(units.size())}, name) +
                                  element(kUint16, bytesOf(units)));
    }
    case MatValue::Type::numbers:
      return element(kMatrix,
                     headOf(kDoubleClass, {std::int32_t(value.size[0]), std::int32_t(value.size[1])}, name) +
                         element(kDouble, bytesOf(value.numbers)));
    case MatValue::Type::cell: {
      std::string bytes = headOf(kCellClass, {1, std::int32_t(value.cells.size())}, name);
      for (const auto& cell : value.cells) bytes += matrixOf(cell, "");
      return element(kMatrix, bytes);
    }
    case MatValue::Type::structure:
      return element(kMatrix, structureOf(value, name));
    case MatValue::Type::other:
      break;
  }
  FACENAV_EXPECT(false, "a value that a .mat cannot hold");
}

}  // namespace

std::string mat5Of(const MatFile& variables) {
  std::string bytes = "MATLAB 5.0 MAT-file, written by FaceNav";
  bytes.resize(124, ' ');
  bytes += bytesOf<std::uint16_t>({0x0100, 0x4D49});  // version; "MI", which tells the order of bytes
  for (const auto& [name, value] : variables) bytes += matrixOf(value, name);
  return bytes;
}

}  // namespace facenav::interop
