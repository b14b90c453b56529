#pragma once
// Content of OpenIGTLink messages: poses, tools, states, texts, points, surfaces, images and requests, to and
// from bytes. A reader returns nothing for content of a wrong size, with an index out of range or a number
// that is not finite. Lengths are mm. Points, surfaces and images are in RAS; an image sent in LPS is turned.

#include <Eigen/Geometry>
#include <array>

#include "facenav/links/igtl_message.h"

namespace facenav::links {

/// TRANSFORM: the columns of the rotation, then the translation.
Bytes transformContent(const Eigen::Isometry3d& pose);
std::optional<Eigen::Isometry3d> readTransform(const Bytes& content);

/// One tool of TDATA; type 2: a pose with six degrees of freedom.
struct IgtlTool {
  std::string name;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  int type = 2;
};
Bytes toolsContent(const std::vector<IgtlTool>& tools);
std::optional<std::vector<IgtlTool>> readTools(const Bytes& content);

/// Place and rotation, as POSITION and QTDATA carry them.
struct IgtlPlace {
  Eigen::Vector3d position_mm = Eigen::Vector3d::Zero();
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();  // as received; it may have any length
};
IgtlPlace placeOf(const Eigen::Isometry3d& pose);
/// POSITION, with the whole quaternion.
Bytes positionContent(const IgtlPlace& place);
/// Reads 12 bytes (no rotation), 24 (the quaternion without w) or 28.
std::optional<IgtlPlace> readPosition(const Bytes& content);

/// One tool of QTDATA.
struct IgtlPlacedTool {
  std::string name;
  IgtlPlace place;
  int type = 2;
};
Bytes placedToolsContent(const std::vector<IgtlPlacedTool>& tools);
std::optional<std::vector<IgtlPlacedTool>> readPlacedTools(const Bytes& content);

enum class IgtlStatusCode { ok = 1, not_found = 4, busy = 6, not_ready = 13, disabled = 15 };
struct IgtlStatus {
  int code = int(IgtlStatusCode::ok);
  std::int64_t subcode = 0;
  std::string name, text;
};
Bytes statusContent(const IgtlStatus& status);
std::optional<IgtlStatus> readStatus(const Bytes& content);

struct IgtlString {
  std::string text;
  int encoding = 106;  // 3: US-ASCII, 106: UTF-8
};
/// STRING; a text of more than 65535 bytes is cut.
Bytes stringContent(const IgtlString& text);
std::optional<IgtlString> readString(const Bytes& content);

struct IgtlPoint {
  std::string name, group = "Fiducial";  // up to 64 and 32 bytes
  std::array<std::uint8_t, 4> rgba{255, 255, 0, 255};
  Eigen::Vector3d position_mm = Eigen::Vector3d::Zero();
  double diameter_mm = 0;
  std::string owner = {};  // up to 20 bytes
};
Bytes pointsContent(const std::vector<IgtlPoint>& points);
std::optional<std::vector<IgtlPoint>> readPoints(const Bytes& content);

/// POLYDATA: a surface of triangles.
struct IgtlSurface {
  std::vector<Eigen::Vector3f> points_mm;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};
Bytes surfaceContent(const IgtlSurface& surface);
/// Reads the polygons, each cut into triangles; vertices, lines, strips and attributes are passed over.
std::optional<IgtlSurface> readSurface(const Bytes& content);

/// IMAGE with one value a voxel, i fastest.
struct IgtlImage {
  std::array<int, 3> size{0, 0, 0};
  Eigen::Matrix3d steps_mm = Eigen::Matrix3d::Identity();  // columns: one voxel along i, j, k
  Eigen::Vector3d centre_mm = Eigen::Vector3d::Zero();     // middle of the outermost voxels' centres
  std::vector<float> voxels;
};
/// Writes 32-bit numbers, little-endian. Throws Error for more than 65535 voxels along an axis.
Bytes imageContent(const IgtlImage& image);
/// Reads a whole image with one component of any of the protocol's numbers.
std::optional<IgtlImage> readImage(const Bytes& content);

/// STT_TDATA and STT_QTDATA: least time between two messages, and the name of the frame.
struct IgtlStart {
  int interval_ms = 0;
  std::string frame;  // up to 32 bytes
};
Bytes startContent(const IgtlStart& start);
std::optional<IgtlStart> readStart(const Bytes& content);
/// RTS_TDATA and the like: 0 is success.
Bytes answerContent(int status);
std::optional<int> readAnswer(const Bytes& content);

}  // namespace facenav::links
