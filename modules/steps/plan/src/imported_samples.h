#pragma once
// A field as another program's file holds it, before it is judged by a case: SimNIBS's meshes, its NIfTI
// volumes, and values on a cortical surface. Private to plan.

#include <filesystem>
#include <optional>
#include <string>

#include "facenav/efield/field_msh.h"
#include "facenav/volume/volume.h"

namespace facenav::steps {

/// Kind of a file by its content; other: none that holds a field.
enum class FieldFile { msh, nifti, surface_values, vtp, other };
FieldFile fieldFileOf(const std::filesystem::path& file);

/// A field on a grid of voxels; 0 where it is not known.
struct FieldImage {
  volume::Volume magnitude;
  std::vector<Eigen::Vector3f> vectors;  // empty: the magnitude alone
};

struct OtherField {
  std::string words;                 // "mesh of gmsh 2.2, E"
  efield::HeadFieldSamples samples;  // not set where the file is an image
  std::optional<FieldImage> image;
};

/// Reads a file. `surface`: the surface of values a vertex. Throws Error: missing, damaged, no field, in the
/// space of a template, values without their surface.
OtherField readOtherField(const std::filesystem::path& file, const std::filesystem::path& surface);

/// The voxels of a mask that have a field, as samples.
efield::FieldSamples samplesIn(const FieldImage& image, const volume::Mask& mask);
/// The field of an image at points; those outside, or where it is 0, are left out.
efield::FieldSamples samplesAt(const FieldImage& image, const std::vector<Eigen::Vector3d>& points_mm);

/// Pose of the coil that SimNIBS writes beside a mesh (.._coil_pos.geo): three vectors at one place, or balls
/// along the y and z axes. Nothing: no such file, or it shows the coil's dipoles or casing alone.
std::optional<Eigen::Matrix4d> poseBeside(const std::filesystem::path& file);

}  // namespace facenav::steps
