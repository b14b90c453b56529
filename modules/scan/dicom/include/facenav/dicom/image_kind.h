#pragma once
// ImageKind: what the voxels of a series show: the signal itself (magnitude), a phase, or a map that was
// computed from several images. Skin and brain are found in a magnitude image, T1-weighted at best. Sources:
// Image Type and Frame Type (PS3.3 C.7.6.1.1.2, C.8.3.1.1.1, C.8.13.3.1.1), Complex Image Component
// (C.8.13.3.1.2), GE's private image type, and the names that vendors write into Image Type and Series
// Description.

#include <string>

namespace facenav::dicom {

enum class ImageKind {
  magnitude,  // also where nothing says otherwise
  uniform,    // MP2RAGE UNI: T1-weighted, its air is noise over the whole range of values
  inversion,  // one inversion time of an MP2RAGE (INV1, INV2)
  phase,
  real,
  imaginary,
  signed_or_uniform,  // the header says magnitude, the values contradict: phase, real part or UNI
  t1_map,
  t2_map,
  rate_map,  // R1, R2, R2*
  density_map,
  field_map,  // B0 or B1
  other_map,
  localizer,
  annotated  // a derived image with marks or words drawn into its voxels
};

/// Name for users: "phase image", "T1 map", "localizer"; "magnitude image" for magnitude.
const char* inWords(ImageKind kind);
/// "a phase image", "an imaginary part".
std::string withArticle(ImageKind kind);
/// Id for other programs: "magnitude", "uniform", "phase", "t1_map", ..
const char* idOf(ImageKind kind);

/// True for a phase image, a real or an imaginary part, and a field map: no skin can be found in them.
bool isWithoutSkin(ImageKind kind);
/// True for a map of a physical quantity.
bool isMap(ImageKind kind);

/// Kind by the texts of the header; an annotated image is known by another attribute. `image_type`: the
/// values of Image Type or Frame Type, with Complex Image Component, separated by backslashes. A statement
/// there outweighs `description`.
ImageKind kindOf(const std::string& image_type, const std::string& description);

}  // namespace facenav::dicom
