#pragma once
// IgtlReader: finds the messages in a stream of bytes from a peer that may be damaged or hostile. A message
// with a wrong CRC or too long a body is passed over without being stored; a stream that is no OpenIGTLink is
// broken for good. The memory that it holds is bounded by the largest body.

#include "facenav/links/igtl_message.h"

namespace facenav::links {

class IgtlReader {
 public:
  /// `largest_body`: bytes of a body that is still read.
  explicit IgtlReader(std::size_t largest_body = 65536) : largest_body_(largest_body) {}

  /// Adds bytes in the order received; call next() until it returns nothing.
  void add(const std::uint8_t* bytes, std::size_t size);
  /// Returns the next whole message with a right CRC; nothing if more bytes are needed.
  std::optional<IgtlMessage> next();
  /// True if the stream cannot be OpenIGTLink: an unknown version, or a body of more than a gigabyte.
  bool isBroken() const { return is_broken_; }
  /// Number of messages with a wrong CRC or contradictory sizes.
  int damaged() const { return damaged_; }
  /// Number of messages passed over because they were too long.
  int passedOver() const { return passed_over_; }
  /// Bytes held.
  std::size_t held() const { return bytes_.size() - at_; }

 private:
  void drop(std::size_t size);

  std::size_t largest_body_;
  Bytes bytes_;
  std::size_t at_ = 0;         // of the first byte that was not used
  std::uint64_t to_skip_ = 0;  // rest of a body that is passed over
  bool is_broken_ = false;
  int damaged_ = 0, passed_over_ = 0;
};

}  // namespace facenav::links
