#include "facenav/links/igtl_message.h"

#include <array>
#include <cmath>

#include "big_endian.h"

namespace facenav::links {
namespace {

constexpr std::size_t kTypeLength = 12;
constexpr std::size_t kExtendedHeaderSize = 12;
constexpr std::uint64_t kCrcPolynomial = 0x42F0E1EBA9EA3693;

/// CRC of each single byte.
const std::array<std::uint64_t, 256>& crcTable() {
  static const auto kTable = [] {
    std::array<std::uint64_t, 256> table{};
    for (std::size_t byte = 0; byte < 256; ++byte) {
      std::uint64_t crc = std::uint64_t(byte) << 56;
      for (int bit = 0; bit < 8; ++bit) crc = crc << 1 ^ (crc >> 63 ? kCrcPolynomial : 0);
      table[byte] = crc;
    }
    return table;
  }();
  return kTable;
}

/// Metadata with the whole name in front if the header cannot hold it.
std::vector<IgtlEntry> sentMetadata(const IgtlMessage& message) {
  auto entries = message.metadata;
  if (message.device.size() > kIgtlDeviceLength && message.value(kIgtlLongName).empty())
    entries.insert(entries.begin(), {kIgtlLongName, message.device});
  return entries;
}

Bytes secondBody(const IgtlMessage& message) {
  const auto entries = sentMetadata(message);
  BigEndianWriter header, values, body;
  header.put(entries.size(), 2);
  for (const auto& entry : entries) {
    header.put(entry.key.size(), 2);
    header.put(entry.encoding, 2);
    header.put(entry.value.size(), 4);
    values.putText(entry.key);
    values.putText(entry.value);
  }
  body.put(kExtendedHeaderSize, 2);
  body.put(header.bytes.size(), 2);
  body.put(values.bytes.size(), 4);
  body.put(message.id, 4);
  for (const Bytes* part :
       std::initializer_list<const Bytes*>{&message.content, &header.bytes, &values.bytes})
    body.bytes.insert(body.bytes.end(), part->begin(), part->end());
  return body.bytes;
}

struct EntrySizes {
  std::size_t key, value;
  std::uint16_t encoding;
};

/// Takes the metadata from its place behind the content. Returns false if its sizes contradict each other.
bool takeMetadata(BigEndianReader& reader, std::size_t header_size, std::size_t values_size,
                  IgtlMessage& message) {
  if (header_size == 0) return values_size == 0;
  const std::size_t count = reader.take(2);
  if (header_size != 2 + 8 * count) return false;
  std::vector<EntrySizes> sizes;
  std::size_t sum = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t key = reader.take(2);
    const auto encoding = std::uint16_t(reader.take(2));
    sizes.push_back({key, std::size_t(reader.take(4)), encoding});
    sum += sizes.back().key + sizes.back().value;
  }
  if (!reader.isGood() || sum != values_size) return false;
  for (const auto& each : sizes) {
    std::string key = reader.takeText(each.key);
    message.metadata.push_back({std::move(key), reader.takeText(each.value), each.encoding});
  }
  return reader.isGood();
}

/// Reads a version 2 body. Returns false if its sizes do not fit together.
bool takeSecondBody(BigEndianReader& reader, IgtlMessage& message) {
  const std::size_t extended = reader.take(2), header_size = reader.take(2), values_size = reader.take(4);
  message.id = std::uint32_t(reader.take(4));
  if (!reader.isGood() || extended < kExtendedHeaderSize) return false;
  reader.takeText(extended - kExtendedHeaderSize);  // a later version's fields
  if (!reader.isGood() || header_size + values_size > reader.left()) return false;
  message.content = reader.takeBytes(reader.left() - header_size - values_size);
  if (!takeMetadata(reader, header_size, values_size, message)) return false;
  const std::string whole = message.value(kIgtlLongName);
  if (whole.rfind(message.device, 0) == 0 && !whole.empty()) message.device = whole;
  return true;
}

}  // namespace

std::string IgtlMessage::value(const std::string& key) const {
  for (const auto& entry : metadata)
    if (entry.key == key) return entry.value;
  return {};
}

std::uint64_t igtlCrc(const std::uint8_t* bytes, std::size_t size) {
  const auto& table = crcTable();
  std::uint64_t crc = 0;
  for (std::size_t i = 0; i < size; ++i) crc = crc << 8 ^ table[(crc >> 56 ^ bytes[i]) & 0xFF];
  return crc;
}

std::uint64_t igtlStamp(std::chrono::system_clock::time_point time) {
  using std::chrono::nanoseconds;
  const auto ns = std::chrono::duration_cast<nanoseconds>(time.time_since_epoch()).count();
  if (ns < 0) return 0;
  const std::uint64_t whole = std::uint64_t(ns) / 1000000000, rest = std::uint64_t(ns) % 1000000000;
  return whole << 32 | ((rest << 32) + 500000000) / 1000000000;
}

std::chrono::system_clock::time_point timeOf(std::uint64_t stamp) {
  const std::uint64_t fraction = stamp & 0xFFFFFFFF;
  const auto ns = std::chrono::nanoseconds((fraction * 1000000000 + (1ull << 31)) >> 32);
  return std::chrono::system_clock::time_point(
      std::chrono::duration_cast<std::chrono::system_clock::duration>(std::chrono::seconds(stamp >> 32) +
                                                                      ns));
}

Bytes encoded(const IgtlMessage& message) {
  const Bytes second = message.header_version >= 2 ? secondBody(message) : Bytes();
  const Bytes& body = message.header_version >= 2 ? second : message.content;
  BigEndianWriter writer;
  writer.bytes.reserve(kIgtlHeaderSize + body.size());
  writer.put(message.header_version >= 2 ? 2 : 1, 2);
  writer.putText(message.type, kTypeLength);
  writer.putText(message.device, kIgtlDeviceLength);
  writer.put(message.stamp, 8);
  writer.put(body.size(), 8);
  writer.put(igtlCrc(body.data(), body.size()), 8);
  writer.bytes.insert(writer.bytes.end(), body.begin(), body.end());
  return writer.bytes;
}

IgtlHeader igtlHeader(const std::uint8_t* bytes) {
  BigEndianReader reader(bytes, kIgtlHeaderSize);
  IgtlHeader header;
  header.version = int(reader.take(2));
  header.type = reader.takeName(kTypeLength);
  header.device = reader.takeName(kIgtlDeviceLength);
  header.stamp = reader.take(8);
  header.body_size = reader.take(8);
  header.crc = reader.take(8);
  return header;
}

std::optional<IgtlMessage> decoded(const IgtlHeader& header, const std::uint8_t* body) {
  const auto size = std::size_t(header.body_size);
  if (igtlCrc(body, size) != header.crc) return std::nullopt;
  IgtlMessage message;
  message.header_version = header.version >= 2 ? 2 : 1;
  message.type = header.type;
  message.device = header.device;
  message.stamp = header.stamp;
  BigEndianReader reader(body, size);
  if (message.header_version == 1)
    message.content = reader.takeBytes(size);
  else if (!takeSecondBody(reader, message))
    return std::nullopt;
  return message;
}

}  // namespace facenav::links
