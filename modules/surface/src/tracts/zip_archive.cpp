#include "zip_archive.h"

#include <libdeflate.h>

#include <cstdint>
#include <cstring>
#include <memory>

#include "tract_formats.h"

namespace facenav::surface {
namespace {

constexpr std::uint64_t kMostBytes = std::uint64_t(8) << 30;  // of one entry, unpacked
constexpr double kMostDeflated = 1040;                        // deflate's limit is 1032

struct Inflater {
  void operator()(libdeflate_decompressor* it) const { libdeflate_free_decompressor(it); }
};

class ZipReader {
 public:
  ZipReader(const std::string& bytes, const std::filesystem::path& path) : bytes_(bytes), path_(path) {}

  std::map<std::string, std::string> entries() {
    std::size_t at = bytes_.size() < 22 ? std::string::npos : bytes_.rfind("PK\5\6", bytes_.size() - 22);
    if (at == std::string::npos) refuseTracts(path_, "it is no whole .trx archive");
    std::uint64_t count = number<std::uint16_t>(at + 10), directory = number<std::uint32_t>(at + 16);
    if ((count == 0xffff || directory == 0xffffffff) && at >= 20 && bytes_.compare(at - 20, 4, "PK\6\7") == 0) {
      const std::uint64_t end = number<std::uint64_t>(at - 12);
      count = number<std::uint64_t>(end + 32);
      directory = number<std::uint64_t>(end + 48);
    }
    std::map<std::string, std::string> all;
    for (std::uint64_t i = 0; i < count; ++i) directory = entry(directory, all);
    return all;
  }

 private:
  template <class T>
  T number(std::uint64_t at) const {
    T value;
    if (at > bytes_.size() || bytes_.size() - at < sizeof value) refuseTracts(path_, "its archive is cut short");
    std::memcpy(&value, bytes_.data() + at, sizeof value);
    return value;
  }

  /// One entry of the directory; returns where the next begins.
  std::uint64_t entry(std::uint64_t at, std::map<std::string, std::string>& all) const {
    if (number<std::uint32_t>(at) != 0x02014b50) refuseTracts(path_, "its archive is damaged");
    const int method = number<std::uint16_t>(at + 10);
    std::uint64_t packed = number<std::uint32_t>(at + 20), whole = number<std::uint32_t>(at + 24),
                  local = number<std::uint32_t>(at + 42);
    const std::uint64_t name_size = number<std::uint16_t>(at + 28), extra_size = number<std::uint16_t>(at + 30);
    const std::uint64_t extra = at + 46 + name_size, next = extra + extra_size + number<std::uint16_t>(at + 32);
    if (extra > bytes_.size()) refuseTracts(path_, "its archive is cut short");
    const std::string name = bytes_.substr(at + 46, name_size);
    for (std::uint64_t e = extra; e + 4 <= extra + extra_size; e += 4 + number<std::uint16_t>(e + 2)) {
      if (number<std::uint16_t>(e) != 1) continue;  // 64-bit sizes, in this order, where the short ones are full
      std::uint64_t value = e + 4;
      for (auto* size : {&whole, &packed, &local})
        if (*size == 0xffffffff) *size = number<std::uint64_t>(value), value += 8;
    }
    if (!name.empty() && name.back() != '/') all[name] = content(local, method, packed, whole);
    return next;
  }

  std::string content(std::uint64_t local, int method, std::uint64_t packed, std::uint64_t whole) const {
    const std::uint64_t begin =
        local + 30 + number<std::uint16_t>(local + 26) + number<std::uint16_t>(local + 28);
    if (begin > bytes_.size() || bytes_.size() - begin < packed || whole > kMostBytes ||
        double(whole) > kMostDeflated * double(packed) + 64)
      refuseTracts(path_, "its archive is damaged");
    if (method == 0) return bytes_.substr(begin, packed);
    if (method != 8) refuseTracts(path_, "its archive is packed in a way that is not known");
    std::string out(whole, '\0');
    const std::unique_ptr<libdeflate_decompressor, Inflater> inflater(libdeflate_alloc_decompressor());
    if (!inflater || libdeflate_deflate_decompress(inflater.get(), bytes_.data() + begin, packed, out.data(),
                                                   whole, nullptr) != LIBDEFLATE_SUCCESS)
      refuseTracts(path_, "its archive is damaged");
    return out;
  }

  const std::string& bytes_;
  const std::filesystem::path& path_;
};

}  // namespace

std::map<std::string, std::string> readZip(const std::string& bytes, const std::filesystem::path& path) {
  return ZipReader(bytes, path).entries();
}

}  // namespace facenav::surface
