// The scalp's field as a file of the case: header (version, digest of the skin), grids, checksum.

#include <algorithm>
#include <cstring>
#include <type_traits>

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "facenav/registration/scalp_field.h"

namespace facenav::registration {
namespace {

constexpr char kMagic[] = "FaceNav scalp field 1\n";  // change the number with every change of the grids

/// A 64-bit digest by words (Murmur's mixing). It detects another skin or a damaged file; it is not
/// cryptographic.
class Digest {
 public:
  void add(const void* bytes, std::size_t size) {
    const char* at = static_cast<const char*>(bytes);
    for (; size >= sizeof(std::uint64_t); at += sizeof(std::uint64_t), size -= sizeof(std::uint64_t)) {
      std::uint64_t word;
      std::memcpy(&word, at, sizeof word);
      mix(word);
    }
    std::uint64_t rest = size;
    std::memcpy(&rest, at, std::min<std::size_t>(size, 7));
    mix(rest ^ std::uint64_t(size) << 56);
  }
  std::uint64_t value() const { return value_; }

 private:
  void mix(std::uint64_t word) {
    value_ = (value_ ^ word) * 0xff51afd7ed558ccdull;
    value_ ^= value_ >> 33;
  }
  std::uint64_t value_ = 0x9e3779b97f4a7c15ull;
};

std::uint64_t digestOf(const SkinModel& skin) {
  Digest digest;
  const auto add = [&](const auto& values) {
    digest.add(values.data(), std::size_t(values.size()) * sizeof(*values.data()));
  };
  add(skin.points.points_mm);
  add(skin.points.normals);
  add(skin.triangles);
  for (const auto& [point, normal] : skin.field_of_view) add(point.mm), add(normal.v);
  return digest.value();
}

class Writer {
 public:
  template <class T>
  void put(const T* values, std::size_t count) {
    static_assert(std::is_trivially_copyable_v<T>);
    content_.append(reinterpret_cast<const char*>(values), count * sizeof(T));
  }
  template <class T>
  void putSized(const std::vector<T>& values) {
    const std::uint64_t count = values.size();
    put(&count, 1);
    put(values.data(), values.size());
  }
  std::string& content() { return content_; }

 private:
  std::string content_;
};

class Reader {
 public:
  explicit Reader(const std::string& content) : content_(content) {}
  template <class T>
  bool get(T* values, std::size_t count) {
    if (count > (content_.size() - at_) / sizeof(T)) return false;
    std::memcpy(values, content_.data() + at_, count * sizeof(T));
    at_ += count * sizeof(T);
    return true;
  }
  template <class T>
  bool getSized(std::vector<T>& values) {
    std::uint64_t count = 0;
    if (!get(&count, 1) || count > (content_.size() - at_) / sizeof(T)) return false;
    values.resize(count);
    return get(values.data(), count);
  }

 private:
  const std::string& content_;
  std::size_t at_ = 0;
};

std::uint64_t checkSum(const std::string& content, std::size_t size) {
  Digest digest;
  digest.add(content.data(), size);
  return digest.value();
}

}  // namespace

void ScalpField::write(const std::filesystem::path& path) const {
  Writer writer;
  const std::uint64_t skin = digestOf(skin_);
  writer.put(kMagic, sizeof kMagic);
  writer.put(&skin, 1);
  for (const Eigen::Vector3d* v : {&low_, &high_, &nose_tip_}) writer.put(v->data(), 3);
  writer.put(origin_.data(), 3);
  writer.put(coarse_size_.data(), 3);
  writer.put(brick_size_.data(), 3);
  writer.putSized(coarse_);
  writer.putSized(brick_at_);
  writer.putSized(bricks_);
  const std::uint64_t sum = checkSum(writer.content(), writer.content().size());
  writer.put(&sum, 1);
  writeWholeFile(path, writer.content());
  using std::filesystem::perms;
  std::filesystem::permissions(path, perms::owner_read | perms::owner_write);  // a head's shape is private
}

bool ScalpField::fillFrom(const std::string& content) {
  std::uint64_t sum = 0, skin = 0;
  char magic[sizeof kMagic];
  if (content.size() < sizeof sum + sizeof magic) return false;
  const std::size_t size = content.size() - sizeof sum;
  std::memcpy(&sum, content.data() + size, sizeof sum);
  Reader reader(content);
  if (!reader.get(magic, sizeof magic) || std::memcmp(magic, kMagic, sizeof magic) != 0) return false;
  if (!reader.get(&skin, 1) || skin != digestOf(skin_) || sum != checkSum(content, size)) return false;
  for (Eigen::Vector3d* v : {&low_, &high_, &nose_tip_})
    if (!reader.get(v->data(), 3)) return false;
  if (!(reader.get(origin_.data(), 3) && reader.get(coarse_size_.data(), 3) &&
        reader.get(brick_size_.data(), 3) && reader.getSized(coarse_) && reader.getSized(brick_at_) &&
        reader.getSized(bricks_)))
    return false;
  showGrids();
  return true;
}

std::shared_ptr<const ScalpField> ScalpField::read(const SkinModel& skin, const std::filesystem::path& path) {
  std::error_code missing;
  if (path.empty() || !std::filesystem::is_regular_file(path, missing)) return {};
  std::shared_ptr<ScalpField> field(new ScalpField(skin, Unfilled{}));
  try {
    if (field->fillFrom(readWholeFile(path))) return field;
  } catch (const Error&) {  // an unreadable file is treated as missing
  }
  return {};
}

std::shared_ptr<const ScalpField> keptScalpField(const SkinModel& skin, const std::filesystem::path& path) {
  if (auto kept = ScalpField::read(skin, path)) return kept;
  auto built = std::make_shared<const ScalpField>(skin);
  try {
    if (!path.empty()) built->write(path);
  } catch (const Error&) {  // folder not writable: built again next time
  } catch (const std::filesystem::filesystem_error&) {
  }
  return built;
}

}  // namespace facenav::registration
