#pragma once
// Checks the items of another program's file against the case's T1 and head, and moves them into Mri. An item
// that cannot be taken gets one line with the reason; nothing is guessed: what only a person knows is asked
// for by the name of an option.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "facenav/interop/item.h"
#include "facenav/interop/t1.h"

namespace facenav::interop {

/// Farthest place of a coil from the middle of the head, mm: an arm's length; beyond it another space is
/// meant.
constexpr double kReach_mm = 400;
/// Largest deviation of the axes from unit length and right angles that counts as rounding and is mended.
constexpr double kLargestSkew = 1e-2;

/// Largest residual of a file's three head points on those of the case, mm (root mean square).
constexpr double kLargestMisfit_mm = 8;

/// Frame that two ears and the nasion make: origin in the middle between the ears, z upwards, and x to the
/// nasion (y to the left ear) or to the right ear (y to the nasion).
enum class HeadFrame { x_nasion, x_right };

/// Answers of the user.
struct Answers {
  std::optional<Space> space;  // ras or lps
  std::optional<Form> form;
  std::optional<HeadFrame> head_frame;
  bool flips_handle = false;  // the file's handle points the other way: x and y are negated
  bool keeps_handle = false;  // a doubtful handle is right as written
};

/// The case, as far as items are judged by it.
struct CaseHead {
  T1 t1;
  Eigen::Vector3d centre_mm = Eigen::Vector3d::Zero();  // of the head
  std::vector<Eigen::Vector3d> skin_mm;                 // points of the skin, some thousand are enough
  std::optional<HeadPoints> points;                     // of the case, in Mri: tragi and nasion
  /// Form that the case was prepared with, if the sform and qform of its T1 differed then; the case's own
  /// copy of the T1 holds this one only. any: they agreed.
  Form used_of_two = Form::any;
};

/// Judges every item of the file; sets mri_T_coil, mri_place, refusal and notes. `file_t1`: the NIfTI that
/// the other program used, if the user named it.
void check(OtherFile& file, const CaseHead& head, const Answers& answers,
           const std::optional<T1>& file_t1 = {});

/// Makes columns unit and orthogonal. Throws Error that says why the pose is none: not finite, left-handed,
/// sheared. `said`, if not null, gets a note where more than rounding was mended.
RigidTransform<Mri, Coil> soundPose(const Eigen::Matrix4d& pose, std::string* said);

}  // namespace facenav::interop
