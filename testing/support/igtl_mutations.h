#pragma once
// Damaged OpenIGTLink streams, the same for each seed, and a receiver that reads everything in them.

#include <algorithm>
#include <random>

#include "facenav/links/igtl_content.h"
#include "facenav/links/igtl_reader.h"

namespace facenav::testing {

/// One message of every kind that we know, in both headers.
inline std::vector<links::IgtlMessage> igtlMessages() {
  using namespace links;
  Eigen::Isometry3d pose(Eigen::AngleAxisd(0.4, Eigen::Vector3d(1, 2, 3).normalized()));
  pose.translation() = Eigen::Vector3d(10, -20, 600);
  IgtlImage image;
  image.size = {3, 2, 2};
  image.voxels.assign(12, 1.5f);
  const IgtlSurface surface{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2}, {0, 2, 3}}};
  std::vector<std::pair<std::string, Bytes>> contents{
      {"TRANSFORM", transformContent(pose)},
      {"TDATA", toolsContent({{"Coil1ToTracker", pose}, {"SubjectToTracker", pose}})},
      {"QTDATA", placedToolsContent({{"Coil1ToTracker", placeOf(pose)}})},
      {"POSITION", positionContent(placeOf(pose))},
      {"STATUS", statusContent({1, 0, "OK", "tracking"})},
      {"STRING", stringContent({"on_target"})},
      {"POINT", pointsContent({{"M1", "Target"}, {"DLPFC", "Target"}})},
      {"POLYDATA", surfaceContent(surface)},
      {"IMAGE", imageContent(image)},
      {"GET_TRANS", {}},
      {"STT_TDATA", startContent({50, "Tracker"})},
      {"STP_TDATA", {}},
      {"RTS_TDATA", answerContent(0)}};
  std::vector<IgtlMessage> messages;
  for (const int version : {1, 2})
    for (const auto& [type, content] : contents) {
      IgtlMessage message;
      message.header_version = version;
      message.type = type;
      message.device = version == 1 ? "Coil1ToTracker" : "CoilReferenceFrameToTracker";
      message.content = content;
      if (version == 2) message.metadata = {{"TransformValid", "1"}, {"TransformStatus", "OK"}};
      messages.push_back(message);
    }
  return messages;
}

struct IgtlFound {
  int messages = 0, contents = 0;
  std::size_t most_held = 0;
};

/// Reads the content as its type says.
inline bool readsContent(const links::IgtlMessage& message) {
  using namespace links;
  const auto& type = message.type;
  const auto& content = message.content;
  if (type == "TRANSFORM") return readTransform(content).has_value();
  if (type == "TDATA") return readTools(content).has_value();
  if (type == "QTDATA") return readPlacedTools(content).has_value();
  if (type == "POSITION") return readPosition(content).has_value();
  if (type == "STATUS") return readStatus(content).has_value();
  if (type == "STRING") return readString(content).has_value();
  if (type == "POINT") return readPoints(content).has_value();
  if (type == "POLYDATA") return readSurface(content).has_value();
  if (type == "IMAGE") return readImage(content).has_value();
  if (type == "STT_TDATA") return readStart(content).has_value();
  return type == "RTS_TDATA" && readAnswer(content).has_value();
}

/// Gives the bytes to a reader in pieces of random length.
inline IgtlFound readAll(links::IgtlReader& reader, const links::Bytes& bytes, std::mt19937& random) {
  IgtlFound found;
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t size = std::min<std::size_t>(bytes.size() - at, 1 + random() % 200);
    reader.add(bytes.data() + at, size);
    at += size;
    found.most_held = std::max(found.most_held, reader.held());
    while (const auto message = reader.next()) {
      ++found.messages;
      found.contents += readsContent(*message);
    }
  }
  return found;
}

/// A message with some bytes changed, cut off or added; in half of them the CRC fits again, so that the
/// damage reaches the readers of the content.
inline links::Bytes mutated(const links::Bytes& whole, std::mt19937& random) {
  links::Bytes bytes = whole;
  for (unsigned changes = 1 + random() % 4; changes > 0; --changes) {
    const std::size_t at = random() % bytes.size();
    switch (random() % 5) {
      case 0:
        bytes[at] = std::uint8_t(random());
        break;
      case 1:
        bytes[at] ^= std::uint8_t(1u << random() % 8);
        break;
      case 2:
        bytes[at] = random() % 2 ? 0xFF : 0;
        break;
      case 3:
        bytes.resize(std::max<std::size_t>(at, 1));
        break;
      default:
        bytes.insert(bytes.begin() + std::ptrdiff_t(at), std::uint8_t(random()));
    }
  }
  if (bytes.size() <= links::kIgtlHeaderSize || random() % 2) return bytes;
  const std::size_t size = bytes.size() - links::kIgtlHeaderSize;
  const std::uint64_t crc = links::igtlCrc(bytes.data() + links::kIgtlHeaderSize, size);
  for (std::size_t i = 0; i < 8; ++i) {
    bytes[42 + i] = std::uint8_t(std::uint64_t(size) >> (56 - 8 * i));
    bytes[50 + i] = std::uint8_t(crc >> (56 - 8 * i));
  }
  return bytes;
}

/// Reads that many mutated messages, each by a reader of its own. Returns the sums.
inline IgtlFound readMutations(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<links::Bytes> whole;
  for (const auto& message : igtlMessages()) whole.push_back(links::encoded(message));
  IgtlFound all;
  for (int n = 0; n < count; ++n) {
    links::IgtlReader reader(4096);
    const auto found = readAll(reader, mutated(whole[random() % whole.size()], random), random);
    all.messages += found.messages;
    all.contents += found.contents;
    all.most_held = std::max(all.most_held, found.most_held);
  }
  return all;
}

}  // namespace facenav::testing
