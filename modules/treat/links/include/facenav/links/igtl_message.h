#pragma once
// OpenIGTLink messages as bytes: header version 1 (58 bytes) and version 2 (with an extended header and
// metadata), big-endian, with a CRC-64 over the whole body. What the content means is in igtl_content.h.
// Source: the protocol's specification, versions 1 to 3 (openigtlink.org).

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace facenav::links {

using Bytes = std::vector<std::uint8_t>;

constexpr std::size_t kIgtlHeaderSize = 58;
constexpr std::size_t kIgtlDeviceLength = 20;  // bytes of a name in the header
/// Key of the metadata that holds a name longer than the header's field.
constexpr const char* kIgtlLongName = "IGTL_DEVICE_NAME";

/// One entry of the metadata; encoding 3: US-ASCII, 106: UTF-8.
struct IgtlEntry {
  std::string key, value;
  std::uint16_t encoding = 3;
};

struct IgtlMessage {
  int header_version = 1;                // 1 or 2
  std::string type, device;              // "TRANSFORM"; name of what is sent
  std::uint64_t stamp = 0;               // seconds since 1970, as 32.32 bits
  Bytes content;                         // without extended header and metadata
  std::vector<IgtlEntry> metadata = {};  // header 2 only
  std::uint32_t id = 0;                  // header 2 only

  /// Value of that key; empty if there is none.
  std::string value(const std::string& key) const;
};

/// Content of the first 58 bytes.
struct IgtlHeader {
  int version = 0;
  std::string type, device;
  std::uint64_t stamp = 0, body_size = 0, crc = 0;
};

/// CRC-64 with polynomial 42F0E1EBA9EA3693, start 0, not reflected, no final xor.
std::uint64_t igtlCrc(const std::uint8_t* bytes, std::size_t size);

std::uint64_t igtlStamp(std::chrono::system_clock::time_point time);
std::chrono::system_clock::time_point timeOf(std::uint64_t stamp);

/// Returns the whole message. A name of more than 20 bytes is cut; with header 2 the metadata keeps it whole.
Bytes encoded(const IgtlMessage& message);
/// Reads the first 58 of the bytes.
IgtlHeader igtlHeader(const std::uint8_t* bytes);
/// Returns the message with that body. Nothing if the CRC is wrong, or the sizes of a version 2 body do not
/// fit together.
std::optional<IgtlMessage> decoded(const IgtlHeader& header, const std::uint8_t* body);

}  // namespace facenav::links
