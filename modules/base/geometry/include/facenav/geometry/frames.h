#pragma once
// The frames of FaceNav as tag types (exact definitions in resources/doc/formats.md; all in millimetres):
//   Mri          patient RAS of the navigation T1 (NIfTI world)
//   Mni          MNI space (RAS mm), of the atlas
//   Camera       left camera: x right, y down, z forward, of the left image as recorded
//   RightCamera  right camera, likewise
//   Head         fixed to the live head: = Camera at the trackers' reference frame
//   Marker       printed square: x right, y down on the print, z into the plate, away from the viewer
//   Coil         contact-face centre: +z into the head, +y along the handle's prolongation away from it,
//                x = y x z
//   Target       the wanted pose of Coil
//   Projector    the dot projector, axes as Camera

namespace facenav {
inline namespace geometry {
inline namespace frames {

struct Mri {};
struct Mni {};
struct Camera {};
struct RightCamera {};
struct Head {};
struct Marker {};
struct Coil {};
struct Target {};
struct Projector {};

}  // namespace frames
}  // namespace geometry
}  // namespace facenav
