#include "facenav/links/igtl_content.h"

#include <algorithm>
#include <cmath>

#include "big_endian.h"

namespace facenav::links {
namespace {

constexpr std::size_t kToolSize = 70, kPlacedToolSize = 50, kPointSize = 136;
constexpr std::size_t kToolName = 20;

void putVector(BigEndianWriter& writer, const Eigen::Vector3d& vector) {
  for (int i = 0; i < 3; ++i) writer.putFloat(vector[i]);
}

Eigen::Vector3d takeVector(BigEndianReader& reader) {
  Eigen::Vector3d vector;
  for (int i = 0; i < 3; ++i) vector[i] = reader.takeFloat();
  return vector;
}

void putPose(BigEndianWriter& writer, const Eigen::Isometry3d& pose) {
  for (int column = 0; column < 4; ++column) putVector(writer, pose.matrix().block<3, 1>(0, column));
}

Eigen::Isometry3d takePose(BigEndianReader& reader) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  for (int column = 0; column < 4; ++column) pose.matrix().block<3, 1>(0, column) = takeVector(reader);
  return pose;
}

void putPlace(BigEndianWriter& writer, const IgtlPlace& place) {
  putVector(writer, place.position_mm);
  putVector(writer, place.rotation.vec());
  writer.putFloat(place.rotation.w());
}

IgtlPlace takePlace(BigEndianReader& reader) {
  IgtlPlace place;
  place.position_mm = takeVector(reader);
  place.rotation.vec() = takeVector(reader);
  place.rotation.w() = reader.takeFloat();
  return place;
}

bool isFinite(const Eigen::Isometry3d& pose) { return pose.matrix().allFinite(); }
bool isFinite(const IgtlPlace& place) {
  return place.position_mm.allFinite() && place.rotation.coeffs().allFinite();
}

}  // namespace

Bytes transformContent(const Eigen::Isometry3d& pose) {
  BigEndianWriter writer;
  putPose(writer, pose);
  return writer.bytes;
}

std::optional<Eigen::Isometry3d> readTransform(const Bytes& content) {
  BigEndianReader reader(content);
  const auto pose = takePose(reader);
  if (!reader.isGood() || reader.left() > 0 || !isFinite(pose)) return std::nullopt;
  return pose;
}

Bytes toolsContent(const std::vector<IgtlTool>& tools) {
  BigEndianWriter writer;
  for (const auto& tool : tools) {
    writer.putText(tool.name, kToolName);
    writer.put(std::uint64_t(tool.type), 1);
    writer.put(0, 1);
    putPose(writer, tool.pose);
  }
  return writer.bytes;
}

std::optional<std::vector<IgtlTool>> readTools(const Bytes& content) {
  if (content.size() % kToolSize != 0) return std::nullopt;
  BigEndianReader reader(content);
  std::vector<IgtlTool> tools(content.size() / kToolSize);
  for (auto& tool : tools) {
    tool.name = reader.takeName(kToolName);
    tool.type = int(reader.take(1));
    reader.take(1);
    tool.pose = takePose(reader);
    if (!isFinite(tool.pose)) return std::nullopt;
  }
  return tools;
}

IgtlPlace placeOf(const Eigen::Isometry3d& pose) {
  Eigen::Quaterniond rotation(pose.linear());
  if (rotation.w() < 0) rotation.coeffs() *= -1;
  return {pose.translation(), rotation};
}

Bytes positionContent(const IgtlPlace& place) {
  BigEndianWriter writer;
  putPlace(writer, place);
  return writer.bytes;
}

std::optional<IgtlPlace> readPosition(const Bytes& content) {
  BigEndianReader reader(content);
  IgtlPlace place;
  if (content.size() == 28) {
    place = takePlace(reader);
  } else if (content.size() == 12 || content.size() == 24) {
    place.position_mm = takeVector(reader);
    if (content.size() == 24) {
      place.rotation.vec() = takeVector(reader);
      place.rotation.w() = std::sqrt(std::max(0.0, 1 - place.rotation.vec().squaredNorm()));
    }
  } else {
    return std::nullopt;
  }
  return isFinite(place) ? std::optional(place) : std::nullopt;
}

Bytes placedToolsContent(const std::vector<IgtlPlacedTool>& tools) {
  BigEndianWriter writer;
  for (const auto& tool : tools) {
    writer.putText(tool.name, kToolName);
    writer.put(std::uint64_t(tool.type), 1);
    writer.put(0, 1);
    putPlace(writer, tool.place);
  }
  return writer.bytes;
}

std::optional<std::vector<IgtlPlacedTool>> readPlacedTools(const Bytes& content) {
  if (content.size() % kPlacedToolSize != 0) return std::nullopt;
  BigEndianReader reader(content);
  std::vector<IgtlPlacedTool> tools(content.size() / kPlacedToolSize);
  for (auto& tool : tools) {
    tool.name = reader.takeName(kToolName);
    tool.type = int(reader.take(1));
    reader.take(1);
    tool.place = takePlace(reader);
    if (!isFinite(tool.place)) return std::nullopt;
  }
  return tools;
}

Bytes statusContent(const IgtlStatus& status) {
  BigEndianWriter writer;
  writer.put(std::uint64_t(status.code), 2);
  writer.put(std::uint64_t(status.subcode), 8);
  writer.putText(status.name, 20);
  writer.putText(status.text);
  writer.put(0, 1);
  return writer.bytes;
}

std::optional<IgtlStatus> readStatus(const Bytes& content) {
  BigEndianReader reader(content);
  IgtlStatus status;
  status.code = int(reader.take(2));
  status.subcode = std::int64_t(reader.take(8));
  status.name = reader.takeName(20);
  status.text = reader.takeName(reader.left());
  return reader.isGood() ? std::optional(status) : std::nullopt;
}

Bytes stringContent(const IgtlString& text) {
  const std::string sent = text.text.substr(0, 65535);
  BigEndianWriter writer;
  writer.put(std::uint64_t(text.encoding), 2);
  writer.put(sent.size(), 2);
  writer.putText(sent);
  return writer.bytes;
}

std::optional<IgtlString> readString(const Bytes& content) {
  BigEndianReader reader(content);
  IgtlString text;
  text.encoding = int(reader.take(2));
  text.text = reader.takeText(reader.take(2));
  return reader.isGood() ? std::optional(text) : std::nullopt;
}

Bytes pointsContent(const std::vector<IgtlPoint>& points) {
  BigEndianWriter writer;
  for (const auto& point : points) {
    writer.putText(point.name, 64);
    writer.putText(point.group, 32);
    for (const auto channel : point.rgba) writer.put(channel, 1);
    putVector(writer, point.position_mm);
    writer.putFloat(point.diameter_mm);
    writer.putText(point.owner, 20);
  }
  return writer.bytes;
}

std::optional<std::vector<IgtlPoint>> readPoints(const Bytes& content) {
  if (content.size() % kPointSize != 0) return std::nullopt;
  BigEndianReader reader(content);
  std::vector<IgtlPoint> points(content.size() / kPointSize);
  for (auto& point : points) {
    point.name = reader.takeName(64);
    point.group = reader.takeName(32);
    for (auto& channel : point.rgba) channel = std::uint8_t(reader.take(1));
    point.position_mm = takeVector(reader);
    point.diameter_mm = reader.takeFloat();
    point.owner = reader.takeName(20);
    if (!point.position_mm.allFinite() || !std::isfinite(point.diameter_mm)) return std::nullopt;
  }
  return points;
}

Bytes startContent(const IgtlStart& start) {
  BigEndianWriter writer;
  writer.put(std::uint64_t(std::int64_t(start.interval_ms)), 4);
  writer.putText(start.frame, 32);
  return writer.bytes;
}

std::optional<IgtlStart> readStart(const Bytes& content) {
  if (content.empty()) return IgtlStart();  // the general scheme: no body
  BigEndianReader reader(content);
  IgtlStart start;
  start.interval_ms = std::max(0, int(std::int32_t(std::uint32_t(reader.take(4)))));
  start.frame = reader.takeName(32);
  return reader.isGood() ? std::optional(start) : std::nullopt;
}

Bytes answerContent(int status) { return {std::uint8_t(status)}; }

std::optional<int> readAnswer(const Bytes& content) {
  if (content.size() != 1) return std::nullopt;
  return int(std::int8_t(content[0]));
}

}  // namespace facenav::links
