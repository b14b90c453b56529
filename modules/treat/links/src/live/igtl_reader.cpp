#include "facenav/links/igtl_reader.h"

#include <algorithm>

namespace facenav::links {
namespace {

constexpr int kNewestHeader = 2;
constexpr std::uint64_t kLongestBody = 1ull << 30;

}  // namespace

void IgtlReader::add(const std::uint8_t* bytes, std::size_t size) {
  if (is_broken_) return;
  const auto skipped = std::size_t(std::min<std::uint64_t>(to_skip_, size));
  to_skip_ -= skipped;
  bytes_.insert(bytes_.end(), bytes + skipped, bytes + size);
}

void IgtlReader::drop(std::size_t size) {
  at_ += size;
  if (at_ < bytes_.size()) return;
  bytes_.clear();
  at_ = 0;
}

std::optional<IgtlMessage> IgtlReader::next() {
  while (!is_broken_ && held() >= kIgtlHeaderSize) {
    const IgtlHeader header = igtlHeader(bytes_.data() + at_);
    if (header.version < 1 || header.version > kNewestHeader || header.body_size > kLongestBody) {
      is_broken_ = true;
      Bytes().swap(bytes_);
      at_ = 0;
      return std::nullopt;
    }
    if (header.body_size > largest_body_) {
      ++passed_over_;
      drop(kIgtlHeaderSize);
      const auto here = std::size_t(std::min<std::uint64_t>(header.body_size, held()));
      to_skip_ = header.body_size - here;
      drop(here);
      continue;
    }
    const auto whole = kIgtlHeaderSize + std::size_t(header.body_size);
    if (held() < whole) break;
    auto message = decoded(header, bytes_.data() + at_ + kIgtlHeaderSize);
    drop(whole);
    if (message) return message;
    ++damaged_;
  }
  if (at_ > 0) {  // keeps the memory bounded by what is not used yet
    bytes_.erase(bytes_.begin(), bytes_.begin() + std::ptrdiff_t(at_));
    at_ = 0;
  }
  return std::nullopt;
}

}  // namespace facenav::links
