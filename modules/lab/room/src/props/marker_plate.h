#pragma once
// The printed plates: an ArUco marker on a white plate, and a chessboard. Object frame = Marker: x right, y
// down on the print, z into the plate; the print lies at z = 0. Edges are exact: the albedo is a function,
// not an image.

#include <memory>
#include <string>

#include "facenav/surface/triangle_mesh.h"
#include "optics/look.h"

namespace facenav::room {

inline constexpr double kPlateThickness_mm = 3.0;
inline constexpr double kPlatePerMarker = 1.4;  // edge of the plate / edge of the black square

surface::TriangleMesh plateMesh(double width_mm, double height_mm);
/// Look of a marker. Throws Error for a dictionary unknown to OpenCV ("4x4_50", "5x5_100", .. "original") or
/// an id outside it.
std::shared_ptr<const Look> makeMarkerLook(const std::string& dictionary, int id, double size_mm);
/// Look of a chessboard with `columns` x `rows` inner corners, its centre at the origin.
std::shared_ptr<const Look> makeChessboardLook(int columns, int rows, double square_mm);

}  // namespace facenav::room
