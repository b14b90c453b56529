#include "prior/prior_weights.h"

#include <zlib.h>

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>

#include "facenav/core/error.h"

namespace facenav::segmentation {
namespace {

constexpr std::uint32_t kVersion = 1, kMostTensors = 1000, kMostRank = 5, kMostSize = 4096;

/// Reads the file's bytes in order; throws past their end.
class Bytes {
 public:
  Bytes(const std::vector<char>& bytes, const std::string& name) : bytes_(bytes), name_(name) {}
  template <class Value>
  Value next() {
    if (at_ + sizeof(Value) > bytes_.size()) fail("ends too early");
    Value value;
    std::memcpy(&value, bytes_.data() + at_, sizeof value);
    at_ += sizeof value;
    return value;
  }
  std::uint32_t nextUpTo(std::uint32_t most) {
    const auto value = next<std::uint32_t>();
    if (value > most) fail("holds a size that is not possible");
    return value;
  }
  bool isAtEnd() const { return at_ == bytes_.size(); }
  [[noreturn]] void fail(const std::string& what) const {
    throw Error("the brain prior's weights cannot be used: the file " + what, name_, "install FaceNav anew");
  }

 private:
  const std::vector<char>& bytes_;
  std::string name_;
  std::size_t at_ = 0;
};

std::vector<char> contentOf(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw Error("the brain prior's weights are missing", path.string(), "install FaceNav anew");
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Verifies and removes the checksum.
void requireWhole(std::vector<char>& content, const Bytes& bytes) {
  std::uint32_t stated = 0;
  if (content.size() < 16) bytes.fail("ends too early");
  std::memcpy(&stated, content.data() + content.size() - sizeof stated, sizeof stated);
  content.resize(content.size() - sizeof stated);
  if (crc32(0, reinterpret_cast<const Bytef*>(content.data()), uInt(content.size())) != stated)
    bytes.fail("is damaged");
}

}  // namespace

std::vector<PriorTensor> readPriorWeights(const std::filesystem::path& path) {
  std::vector<char> content = contentOf(path);
  Bytes bytes(content, path.string());
  requireWhole(content, bytes);
  const auto magic = bytes.next<std::array<char, 4>>();
  if (std::memcmp(magic.data(), "FNBP", 4) != 0) bytes.fail("is of another kind");
  if (bytes.next<std::uint32_t>() != kVersion) bytes.fail("is of another version");
  std::vector<PriorTensor> tensors(bytes.nextUpTo(kMostTensors));
  for (auto& tensor : tensors) {
    std::size_t count = 1;
    tensor.size.resize(bytes.nextUpTo(kMostRank));
    for (int& size : tensor.size) count *= std::size_t(size = int(bytes.nextUpTo(kMostSize)));
    if (count > content.size()) bytes.fail("holds a size that is not possible");
    tensor.values.resize(count);
  }
  for (auto& tensor : tensors)
    for (float& value : tensor.values)
      value = float(Eigen::numext::bit_cast<Eigen::half>(bytes.next<std::uint16_t>()));
  if (!bytes.isAtEnd()) bytes.fail("is longer than it says");
  return tensors;
}

}  // namespace facenav::segmentation
