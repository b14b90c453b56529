#pragma once
// CortexField: the map from a coil to the field on the cortex, compressed to modes, so that a pose costs some
// 0.1 ms to 2 ms. Input: the coil's own field at some hundred places in the head; output: the field at the
// points. Made once per head from a FieldSolver (some seconds), kept in a file. Fields: V/m at 1 A/us, Mri.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "facenav/core/file_access.h"
#include "facenav/efield/field_solver.h"

namespace facenav::efield {

struct CortexField {
  Eigen::Matrix3Xf points_mm;          // where the field is given
  std::vector<std::uint8_t> is_moved;  // 1: moved inwards, see reachablePoints()
  Eigen::Matrix3Xf samples_mm;         // where the coil's own field is taken; multiple of 16
  Eigen::Index modes = 0;              // multiple of 32
  std::vector<float> intake;           // [modes / 32][3 samples][32]: own field to modes
  std::vector<std::int16_t> shapes;    // [rows / 32][modes][32]: modes to field, rows x y z of each point
  double mode_error = 0;  // root mean square relative error of the intake, on sources it was not fitted to
};

/// Makes the modes for points of the cortex (3 x n, Mri). `most_modes`: a multiple of 32; 288 leave
/// 0.3 % of the field of a figure-8 coil. Throws Error for no points, Cancelled.
CortexField makeCortexField(const FieldSolver& solver, const Eigen::Matrix3Xd& points_mm,
                            TaskMonitor& monitor, int most_modes = 288);
/// Makes the same map with less memory: the solver's equations are freed when they are used up.
CortexField makeCortexField(FieldSolver&& solver, const Eigen::Matrix3Xd& points_mm, TaskMonitor& monitor,
                            int most_modes = 288);

/// Field at all points, 3 x n. One thread.
Eigen::Matrix3Xf fieldAt(const CortexField& field, const CoilDipoles& coil,
                         const RigidTransform<Mri, frames::Coil>& mri_T_coil);

/// Writes the field and the text `model`, which identifies the head that it belongs to. Whole file or
/// nothing.
void writeCortexField(const CortexField& field, const std::string& model, const std::filesystem::path& path,
                      FileAccess access = FileAccess::owner_only);
/// The text `model` of a file. Throws Error: no such file, not a field.
std::string modelOfFile(const std::filesystem::path& path);
/// Reads a field. Throws Error: no such file, damaged, or written for another model.
CortexField readCortexField(const std::filesystem::path& path, const std::string& model);

}  // namespace facenav::efield
