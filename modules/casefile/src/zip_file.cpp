#include "facenav/casefile/zip_file.h"

#include <array>
#include <cstdint>
#include <cstring>

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"

namespace facenav::casefile {
namespace fs = std::filesystem;
namespace {

constexpr std::uint32_t kLocal = 0x04034b50, kCentral = 0x02014b50, kEnd = 0x06054b50;
constexpr std::size_t kLocalSize = 30, kCentralSize = 46, kEndSize = 22, kMostBytes = std::size_t(1) << 31;
constexpr std::uint16_t kVersion = 20, kUtf8 = 0x0800, kDate = 0x5821;  // one date for all: 2024-01-01

std::uint32_t crc32(const std::string& bytes) {
  static const auto table = [] {
    std::array<std::uint32_t, 256> made{};
    for (std::uint32_t i = 0; i < 256; ++i) {
      std::uint32_t value = i;
      for (int bit = 0; bit < 8; ++bit) value = value & 1 ? 0xEDB88320u ^ (value >> 1) : value >> 1;
      made[i] = value;
    }
    return made;
  }();
  std::uint32_t sum = 0xFFFFFFFFu;
  for (const char c : bytes) sum = table[(sum ^ std::uint8_t(c)) & 0xFF] ^ (sum >> 8);
  return ~sum;
}

template <class T>
void put(std::string& out, T value) {
  for (std::size_t i = 0; i < sizeof value; ++i) out += char(std::uint64_t(value) >> (8 * i) & 0xFF);
}

/// What local header and directory say alike of an entry, from the version on.
void putCommon(std::string& out, const std::string& name, const std::string& content, std::uint32_t sum) {
  put<std::uint16_t>(out, kVersion);
  put<std::uint16_t>(out, kUtf8);
  put<std::uint16_t>(out, 0);  // stored
  put<std::uint16_t>(out, 0);
  put<std::uint16_t>(out, kDate);
  put<std::uint32_t>(out, sum);
  put<std::uint32_t>(out, std::uint32_t(content.size()));
  put<std::uint32_t>(out, std::uint32_t(content.size()));
  put<std::uint16_t>(out, std::uint16_t(name.size()));
  put<std::uint16_t>(out, 0);
}

void putCentral(std::string& out, const std::string& name, const std::string& content, std::uint32_t sum,
                std::size_t at) {
  put(out, kCentral);
  put<std::uint16_t>(out, kVersion);
  putCommon(out, name, content, sum);
  for (int i = 0; i < 3; ++i) put<std::uint16_t>(out, 0);
  put<std::uint32_t>(out, 0);
  put<std::uint32_t>(out, std::uint32_t(at));
  out += name;
}

class ZipParts {
 public:
  ZipParts(const std::string& bytes, const fs::path& path) : bytes_(bytes), path_(path) {}

  std::map<std::string, std::string> entries() const {
    const std::size_t end = bytes_.size() < kEndSize ? std::string::npos : bytes_.rfind("PK\5\6");
    if (end == std::string::npos) refuse("is no whole file: its end is missing");
    std::map<std::string, std::string> all;
    std::size_t at = number<std::uint32_t>(end + 16);
    for (int left = number<std::uint16_t>(end + 10); left > 0; --left) at = entry(at, all);
    return all;
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const {
    throw Error(what, path_.string(), "copy it again from where it came from");
  }
  template <class T>
  T number(std::size_t at) const {
    if (at > bytes_.size() || bytes_.size() - at < sizeof(T)) refuse("is cut short");
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < sizeof(T); ++i)
      value |= std::uint64_t(std::uint8_t(bytes_[at + i])) << (8 * i);
    return T(value);
  }
  std::string part(std::size_t at, std::size_t size) const {
    if (at > bytes_.size() || bytes_.size() - at < size) refuse("is cut short");
    return bytes_.substr(at, size);
  }
  std::size_t entry(std::size_t at, std::map<std::string, std::string>& all) const {
    if (number<std::uint32_t>(at) != kCentral) refuse("is damaged");
    const std::size_t name_size = number<std::uint16_t>(at + 28), next = at + kCentralSize + name_size +
                                                                         number<std::uint16_t>(at + 30) +
                                                                         number<std::uint16_t>(at + 32);
    const std::string name = part(at + kCentralSize, name_size);
    if (number<std::uint16_t>(at + 10) != 0) refuse("was packed by another program");
    requireInside(name);
    const std::size_t local = number<std::uint32_t>(at + 42), size = number<std::uint32_t>(at + 24);
    const std::size_t begin =
        local + kLocalSize + number<std::uint16_t>(local + 26) + number<std::uint16_t>(local + 28);
    std::string content = part(begin, size);
    if (crc32(content) != number<std::uint32_t>(at + 16)) refuse("is damaged: '" + name + "' has changed");
    all[name] = std::move(content);
    return next;
  }
  void requireInside(const std::string& name) const {
    const fs::path relative = fs::path(name).lexically_normal();
    if (name.empty() || relative.is_absolute() || *relative.begin() == "..")
      refuse("holds a name that leads elsewhere");
  }

  const std::string& bytes_;
  const fs::path& path_;
};

}  // namespace

void writeZip(const std::map<std::string, std::string>& entries, const fs::path& path, FileAccess access) {
  std::string out, directory;
  for (const auto& [name, content] : entries) {
    if (out.size() + content.size() >= kMostBytes) throw Error("too much for one file", path.string());
    const std::uint32_t sum = crc32(content);
    putCentral(directory, name, content, sum, out.size());
    put(out, kLocal);
    putCommon(out, name, content, sum);
    out += name + content;
  }
  const std::size_t begin = out.size();
  out += directory;
  put(out, kEnd);
  put<std::uint32_t>(out, 0);
  put<std::uint16_t>(out, std::uint16_t(entries.size()));
  put<std::uint16_t>(out, std::uint16_t(entries.size()));
  put<std::uint32_t>(out, std::uint32_t(directory.size()));
  put<std::uint32_t>(out, std::uint32_t(begin));
  put<std::uint16_t>(out, 0);
  writeWholeFile(path, out, access);
}

std::map<std::string, std::string> readZip(const fs::path& path) {
  const std::string bytes = readWholeFile(path);
  return ZipParts(bytes, path).entries();
}

}  // namespace facenav::casefile
