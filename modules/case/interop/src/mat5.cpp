#include "mat5.h"

#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "facenav/core/error.h"
#include "text.h"

namespace facenav::interop {
namespace {

constexpr std::size_t kMostUnpacked = 256u << 20;
constexpr int kDeepest = 20;  // structures within structures
enum DataType : std::uint32_t {
  kInt8 = 1,
  kUint8,
  kInt16,
  kUint16,
  kInt32,
  kUint32,
  kSingle,
  kDouble = 9,
  kInt64 = 12,
  kUint64,
  kMatrix,
  kCompressed,
  kUtf8,
  kUtf16,
  kUtf32
};
enum ArrayClass : std::uint8_t {
  kCellClass = 1,
  kStructClass,
  kObjectClass,
  kCharClass,
  kSparseClass,
  kDoubleClass,
  kUint64Class = 15
};

/// A stretch of bytes that is read from its beginning.
class Bytes {
 public:
  Bytes(const unsigned char* begin, std::size_t size, bool is_swapped, const std::filesystem::path& path)
      : at_(begin), left_(size), is_swapped_(is_swapped), path_(path) {}

  std::size_t left() const { return left_; }
  bool isSwapped() const { return is_swapped_; }
  [[noreturn]] void refuse() const {
    refuseFile(path_, "", "is cut short or damaged", "copy or export it again");
  }
  const unsigned char* take(std::size_t count) {
    if (count > left_) refuse();
    const auto* begin = at_;
    at_ += count;
    left_ -= count;
    return begin;
  }
  template <class T>
  T number() {
    unsigned char raw[sizeof(T)];
    std::memcpy(raw, take(sizeof(T)), sizeof(T));
    if (is_swapped_) std::reverse(raw, raw + sizeof(T));
    T value;
    std::memcpy(&value, raw, sizeof(T));
    return value;
  }
  Bytes part(std::size_t count) { return {take(count), count, is_swapped_, path_}; }
  const std::filesystem::path& path() const { return path_; }

 private:
  const unsigned char* at_;
  std::size_t left_;
  bool is_swapped_;
  const std::filesystem::path& path_;
};

struct Element {
  std::uint32_t type;
  Bytes bytes;
};

/// Takes the next element with its padding; up to four bytes may stand in the tag itself.
Element elementOf(Bytes& from) {
  const auto first = from.number<std::uint32_t>();
  if (first >> 16) {
    const std::size_t size = first >> 16;
    if (size > 4) from.refuse();
    Bytes bytes = from.part(size);
    from.take(4 - size);
    return {first & 0xFFFF, bytes};
  }
  const auto size = from.number<std::uint32_t>();
  Bytes bytes = from.part(size);
  if (first != kCompressed && size % 8) from.take(std::min<std::size_t>(8 - size % 8, from.left()));
  return {first, bytes};
}

template <class T>
std::vector<double> asDoubles(Bytes bytes) {
  std::vector<double> values;
  values.reserve(bytes.left() / sizeof(T));
  while (bytes.left() >= sizeof(T)) values.push_back(double(bytes.number<T>()));
  return values;
}

std::vector<double> numbersOf(const Element& element) {
  switch (element.type) {
    case kInt8:
      return asDoubles<std::int8_t>(element.bytes);
    case kUint8:
    case kUtf8:
      return asDoubles<std::uint8_t>(element.bytes);
    case kInt16:
      return asDoubles<std::int16_t>(element.bytes);
    case kUint16:
    case kUtf16:
      return asDoubles<std::uint16_t>(element.bytes);
    case kInt32:
      return asDoubles<std::int32_t>(element.bytes);
    case kUint32:
    case kUtf32:
      return asDoubles<std::uint32_t>(element.bytes);
    case kSingle:
      return asDoubles<float>(element.bytes);
    case kDouble:
      return asDoubles<double>(element.bytes);
    case kInt64:
      return asDoubles<std::int64_t>(element.bytes);
    case kUint64:
      return asDoubles<std::uint64_t>(element.bytes);
    default:
      element.bytes.refuse();
  }
}

void appendUtf8(std::string& text, std::uint32_t code) {
  if (code < 0x80) {
    text += char(code);
  } else if (code < 0x800) {
    text += char(0xC0 | (code >> 6));
    text += char(0x80 | (code & 0x3F));
  } else if (code < 0x10000) {
    text += char(0xE0 | (code >> 12));
    text += char(0x80 | ((code >> 6) & 0x3F));
    text += char(0x80 | (code & 0x3F));
  } else {
    text += char(0xF0 | ((code >> 18) & 0x07));
    text += char(0x80 | ((code >> 12) & 0x3F));
    text += char(0x80 | ((code >> 6) & 0x3F));
    text += char(0x80 | (code & 0x3F));
  }
}

std::string textOf(const Element& element) {
  std::string text;
  const auto units = numbersOf(element);
  if (element.type == kUtf8 || element.type == kInt8) {
    for (const double unit : units) text += char(std::uint8_t(std::int64_t(unit)));
    return text;
  }
  for (std::size_t i = 0; i < units.size(); ++i) {
    std::uint32_t code = std::uint32_t(units[i]);
    const bool is_pair = code >= 0xD800 && code < 0xDC00 && i + 1 < units.size();
    if (is_pair) code = 0x10000 + ((code - 0xD800) << 10) + (std::uint32_t(units[++i]) - 0xDC00);
    appendUtf8(text, code);
  }
  return text;
}

MatValue valueOf(Bytes bytes, std::string* name, int depth);

void readCell(Bytes& bytes, std::size_t count, MatValue& value, int depth) {
  value.type = MatValue::Type::cell;
  for (std::size_t i = 0; i < count; ++i) {
    const Element element = elementOf(bytes);
    if (element.type != kMatrix) bytes.refuse();
    value.cells.push_back(valueOf(element.bytes, nullptr, depth + 1));
  }
}

void readStructure(Bytes& bytes, std::size_t count, MatValue& value, int depth) {
  value.type = MatValue::Type::structure;
  const auto length = numbersOf(elementOf(bytes));
  if (length.size() != 1 || length[0] < 1 || length[0] > 4096) bytes.refuse();
  const std::string names = textOf([&] {
    Element element = elementOf(bytes);
    element.type = kInt8;
    return element;
  }());
  const auto step = std::size_t(length[0]);
  for (std::size_t begin = 0; begin < names.size(); begin += step)
    value.fields.emplace_back(names.substr(begin, step).c_str());
  for (std::size_t i = 0; i < count; ++i) {
    std::map<std::string, MatValue> fields;
    for (const auto& field : value.fields) {
      const Element element = elementOf(bytes);
      if (element.type != kMatrix) bytes.refuse();
      fields[field] = valueOf(element.bytes, nullptr, depth + 1);
    }
    value.elements.push_back(std::move(fields));
  }
}

/// Value of a matrix element's content.
MatValue valueOf(Bytes bytes, std::string* name, int depth) {
  MatValue value;
  if (bytes.left() == 0) return value;  // an empty array
  if (depth > kDeepest) bytes.refuse();
  const auto flags = numbersOf(elementOf(bytes));
  if (flags.empty()) bytes.refuse();
  const auto array_class = std::uint8_t(std::uint32_t(flags[0]) & 0xFF);
  std::size_t count = 1;
  for (const double extent : numbersOf(elementOf(bytes))) {
    if (!(extent >= 0) || extent > 1e9) bytes.refuse();
    value.size.push_back(std::size_t(extent));
    count *= value.size.back();
    if (count > kMostUnpacked) bytes.refuse();
  }
  const std::string own = textOf(elementOf(bytes));
  if (name) *name = own;
  // Every element of a cell or structure takes 8 bytes at least, so a false count ends at the end of the
  // bytes.
  if (array_class == kCellClass) {
    readCell(bytes, count, value, depth);
  } else if (array_class == kStructClass) {
    readStructure(bytes, count, value, depth);
  } else if (array_class == kCharClass) {
    value.type = MatValue::Type::text;
    value.text = count == 0 && bytes.left() == 0 ? std::string() : textOf(elementOf(bytes));
  } else if (array_class >= kDoubleClass && array_class <= kUint64Class) {
    value.type = MatValue::Type::numbers;
    value.numbers = numbersOf(elementOf(bytes));
    if (value.numbers.size() != count) bytes.refuse();
  }
  return value;
}

std::string unpacked(Bytes packed) {
  std::string result;
  z_stream stream{};
  if (inflateInit(&stream) != Z_OK) packed.refuse();
  const std::size_t size = packed.left();
  stream.next_in = const_cast<unsigned char*>(packed.take(size));
  stream.avail_in = uInt(size);
  int state = Z_OK;
  char buffer[1 << 14];
  while (state == Z_OK && result.size() <= kMostUnpacked) {
    stream.next_out = reinterpret_cast<unsigned char*>(buffer);
    stream.avail_out = sizeof buffer;
    state = inflate(&stream, Z_NO_FLUSH);
    result.append(buffer, sizeof buffer - stream.avail_out);
  }
  inflateEnd(&stream);
  if (state != Z_STREAM_END) packed.refuse();
  return result;
}

}  // namespace

MatFile readMat5(const std::string& content, const std::filesystem::path& path) {
  const auto* begin = reinterpret_cast<const unsigned char*>(content.data());
  Bytes header(begin, content.size(), false, path);
  if (content.size() < 128) header.refuse();
  const bool is_swapped = content[126] == 'M' && content[127] == 'I';  // "IM" on a machine like this one
  Bytes bytes(begin + 128, content.size() - 128, is_swapped, path);
  MatFile file;
  while (bytes.left() >= 8) {
    const Element element = elementOf(bytes);
    std::string name;
    if (element.type == kMatrix) {
      MatValue value = valueOf(element.bytes, &name, 0);
      file.emplace_back(name, std::move(value));
    } else if (element.type == kCompressed) {
      const std::string inner = unpacked(element.bytes);
      Bytes inner_bytes(reinterpret_cast<const unsigned char*>(inner.data()), inner.size(), is_swapped, path);
      const Element matrix = elementOf(inner_bytes);
      if (matrix.type != kMatrix) continue;
      MatValue value = valueOf(matrix.bytes, &name, 0);
      file.emplace_back(name, std::move(value));
    }
  }
  if (bytes.left() != 0) bytes.refuse();
  return file;
}

MatValue MatValue::of(const std::string& words) {
  MatValue value;
  value.type = Type::text;
  value.text = words;
  return value;
}

MatValue MatValue::of(std::vector<double> values, std::size_t rows, std::size_t columns) {
  MatValue value;
  value.type = Type::numbers;
  value.size = {rows, columns};
  value.numbers = std::move(values);
  return value;
}

MatValue MatValue::cellOf(std::vector<MatValue> values) {
  MatValue value;
  value.type = Type::cell;
  value.size = {1, values.size()};
  value.cells = std::move(values);
  return value;
}

MatValue MatValue::structureOf(std::vector<std::map<std::string, MatValue>> values,
                               std::vector<std::string> names) {
  MatValue value;
  value.type = Type::structure;
  value.size = {1, values.size()};
  value.elements = std::move(values);
  value.fields = std::move(names);
  return value;
}

}  // namespace facenav::interop
