#include "facenav/interop/check.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/geometry/json_transform.h"
#include "facenav/geometry/rigid_fit.h"
#include "facenav/geometry/rotation.h"
#include "facenav/interop/axes.h"
#include "handle_words.h"
#include "skin_distance.h"

namespace facenav::interop {
namespace {

constexpr double kSameT1_mm = 0.1;        // two maps that agree at all corners
constexpr double kRounded = 6e-4;         // deviation that 4 decimals can cause
constexpr double kFromSkin_mm = 60;       // no coil is planned farther from the skin
constexpr double kNearSkin_mm = 30;       // coils with thick hair and a cap under them lie nearer
constexpr double kOnEdge = 0.35;          // cosine: 70 degrees from the way to the head's middle
constexpr double kAlongOther = 0.8;       // cosine: the other axis lies within 37 degrees of it
constexpr double kOtherSpaceBetter = 15;  // mm nearer to the skin: the other reading fits better

/// Why the file as a whole cannot be taken; empty if it can.
std::string faultOfSpace(Space space, const OtherFile& file) {
  const std::string words = file.space_words.empty() ? toString(space) : file.space_words;
  switch (space) {
    case Space::ras:
    case Space::lps:
      return {};
    case Space::mni:
    case Space::talairach:
    case Space::other_template:
      return "its coordinates are " + words +
             ", a template's and not this patient's: export it in the T1's own space";
    case Space::unknown:
      return "its coordinates are " +
             (words.empty() ? std::string("of no stated space") : "'" + words + "'") +
             ", of which RAS or LPS is not certain: give --space lps or --space ras";
  }
  return {};
}

/// Changes the file's world, made RAS, into Mri.
struct WorldChange {
  Eigen::Affine3d mri_T_world = Eigen::Affine3d::Identity();
  std::string refusal;
  std::vector<std::string> notes;
};

std::string millimetres(double mm) { return formatted(mm < 10 ? "%.1f mm" : "%.0f mm", mm); }

/// Why another T1 has other voxels than the case's; empty if they are as many and as large.
std::string faultOfVoxels(const volume::VoxelGrid& theirs, const volume::VoxelGrid& ours) {
  const std::string apart =
      ", corners up to " +
      millimetres(cornersApart_mm(theirs.mri_from_voxel, ours.mri_from_voxel, theirs.size)) + " apart";
  const auto &a = theirs.size, &b = ours.size;
  if (a != b)
    return formatted("its T1 is another one: %d x %d x %d voxels, the case's has %d x %d x %d", a[0], a[1],
                     a[2], b[0], b[1], b[2]) +
           apart;
  const double differs_mm = (theirs.spacing_mm() - ours.spacing_mm()).cwiseAbs().maxCoeff();
  return differs_mm > 1e-3 ? "its T1 has other voxel sizes than the case's" + apart : std::string();
}

/// The file's world by the NIfTI that the user named. Both images may be stored in any order of voxels.
WorldChange byNamedT1(const T1& theirs, Form form, const CaseHead& head) {
  WorldChange change;
  const auto their_grid = canonical(theirs.grid), our_grid = canonical(head.t1.grid);
  change.refusal = faultOfVoxels(their_grid, our_grid);
  if (!change.refusal.empty()) return change;
  const Eigen::Affine3d used_T_file = theirs.grid.mri_from_voxel * theirs.map(form).inverse();
  const Eigen::Affine3d moved = our_grid.mri_from_voxel * their_grid.mri_from_voxel.inverse() * used_T_file;
  const double moved_mm =
      cornersApart_mm(moved * our_grid.mri_from_voxel, our_grid.mri_from_voxel, our_grid.size);
  if (moved_mm <= 1e-3) return change;
  change.mri_T_world = moved;
  change.notes.push_back("its T1 has the case's voxels in another world, corners up to " +
                         millimetres(moved_mm) + " apart: poses are moved by it");
  return change;
}

/// The file's world by what it says of its own T1.
WorldChange byOwnWords(const OtherFile& file, Form form, const CaseHead& head) {
  WorldChange change;
  const T1& t1 = head.t1;
  if (file.image) {
    volume::VoxelGrid ours = t1.grid;
    if (t1.qform) ours.mri_from_voxel = *t1.qform;
    const auto their_grid = canonicalOf(file.image->affine(), ours), our_grid = canonical(ours);
    const double apart_mm =
        cornersApart_mm(their_grid.mri_from_voxel, our_grid.mri_from_voxel, our_grid.size);
    if (apart_mm > kSameT1_mm)
      change.refusal = "it belongs to another T1: by its qform the corners lie up to " +
                       millimetres(apart_mm) + " from the case's; name the T1 with --t1";
    if (apart_mm > kSameT1_mm) return change;
  }
  const bool is_said = form != Form::any || file.is_form_doubtful;
  if (head.used_of_two != Form::any && form != head.used_of_two && is_said) {
    change.refusal =
        "sform and qform of this T1 differed when the case was prepared: name that T1 with --t1, and its "
        "form "
        "with --form if the file says none";
    return change;
  }
  const double apart_mm = t1.formsApart_mm();
  if (form == Form::any) {
    if (apart_mm <= kSameT1_mm) return change;
    const std::string differ = "sform and qform of the T1 lie up to " + millimetres(apart_mm) + " apart";
    if (file.is_form_doubtful)
      change.refusal =
          differ + " and the file does not say which it means: give --form sform or --form qform";
    else
      change.notes.push_back(differ + "; the " + t1.used + " is taken");
    return change;
  }
  // A T1 with one form, or two that agree, has one world.
  if (!t1.sform || !t1.qform || apart_mm <= 1e-3) return change;
  change.mri_T_world = t1.grid.mri_from_voxel * t1.map(form).inverse();
  return change;
}

constexpr const char* kNoLandmarks =
    "its frame is that of nasion and ears, and the case has no landmarks: set them first (plan)";

/// The file's world by the case's own landmarks, for a file that holds none.
WorldChange byHeadFrame(const std::optional<HeadFrame>& frame, const CaseHead& head) {
  WorldChange change;
  if (!frame)
    change.refusal =
        "its frame is that of nasion and ears, and the file does not say where its x points: give "
        "--head-frame x-nasion or --head-frame x-right";
  else if (!head.points)
    change.refusal = kNoLandmarks;
  if (!change.refusal.empty()) return change;
  const Eigen::Vector3d middle = (head.points->left_ear + head.points->right_ear) / 2;
  const Eigen::Vector3d to_nasion = head.points->nasion - middle;
  const Eigen::Vector3d to_right = head.points->right_ear - middle;
  const Eigen::Vector3d z = to_right.cross(to_nasion).normalized();
  const bool is_nasion = *frame == HeadFrame::x_nasion;
  const Eigen::Vector3d x = (is_nasion ? to_nasion : to_right).normalized();
  change.mri_T_world.linear() << x, z.cross(x), z;
  change.mri_T_world.translation() = middle;
  change.notes.push_back(std::string("its frame is made from the case's nasion and tragi, x to the ") +
                         (is_nasion ? "nasion" : "right ear") +
                         "; the file holds no landmarks, so no residual can be stated");
  return change;
}

/// The file's world by its three points of the head.
WorldChange byHeadPoints(const HeadPoints& theirs, const CaseHead& head) {
  WorldChange change;
  if (!head.points) {
    change.refusal = kNoLandmarks;
    return change;
  }
  const auto listOf = [](const HeadPoints& points) {
    return std::vector<Eigen::Vector3d>{points.left_ear, points.nasion, points.right_ear};
  };
  const auto fit = fitRigidPoints(listOf(theirs), listOf(*head.points));
  const std::string misfit =
      formatted("nasion and ears of the file fit those of the case to %.1f mm", fit.rms_mm);
  if (fit.rms_mm > kLargestMisfit_mm)
    change.refusal = misfit + formatted("; at most %.0f mm are taken", kLargestMisfit_mm);
  else
    change.notes.push_back(misfit);
  change.mri_T_world = Eigen::Affine3d(fit.to_T_from.matrix());
  return change;
}

Eigen::Matrix4d inRas(const Eigen::Matrix4d& pose, Space space) {
  return space == Space::lps ? Eigen::Matrix4d(lpsFromRas() * pose) : pose;
}

Eigen::Vector3d inRas(const Eigen::Vector3d& p, Space space) {
  return space == Space::lps ? Eigen::Vector3d(-p.x(), -p.y(), p.z()) : p;
}

/// What all items of a file are judged by.
struct Judging {
  const CaseHead& head;
  const Answers& answers;
  Space space;
  WorldChange change;
  bool is_handle_doubtful;
};

/// Asks which way the handle points, or says how it was answered.
void judgeHandle(Item& item, const Answers& answers) {
  const Eigen::Vector3d y = item.mri_T_coil->rotation().col(1);
  if (answers.flips_handle || answers.keeps_handle) {
    item.notes.push_back("its handle points " + directionInWords(-y));
    return;
  }
  item.refusal = handleQuestion(y);
  item.mri_T_coil.reset();
}

void judgePose(Item& item, const Judging& by) {
  const CaseHead& head = by.head;
  Eigen::Matrix4d pose = inRas(*item.pose, by.space);
  if (by.answers.flips_handle) pose.block<3, 2>(0, 0) *= -1;
  std::string said;
  try {
    soundPose(pose, &said);  // before the world is changed: the fault is the file's
    item.mri_T_coil = soundPose(by.change.mri_T_world.matrix() * pose, nullptr);
  } catch (const Error& error) {
    item.refusal = error.what();
    return;
  }
  if (!said.empty()) item.notes.push_back(said);
  const Eigen::Vector3d centre_mm = item.mri_T_coil->translation_mm();
  const double away_mm = (centre_mm - head.centre_mm).norm();
  if (away_mm > kReach_mm) {
    item.refusal = "its centre lies " + millimetres(away_mm) + " from the middle of the head";
    item.mri_T_coil.reset();
    return;
  }
  const Eigen::Vector3d inwards = (head.centre_mm - centre_mm).normalized();
  const Eigen::Vector3d into_head = item.mri_T_coil->rotation().transpose() * inwards;
  if (into_head.z() < -0.2)
    item.notes.push_back("its axis points out of the head: compare it with the other program");
  else if (into_head.z() < kOnEdge && into_head.head<2>().cwiseAbs().maxCoeff() > kAlongOther)
    item.notes.push_back(formatted(
        "its coil stands on edge: its %c axis, not z, points into the head or out of it; are its axes "
        "in another order?",
        std::abs(into_head.x()) > std::abs(into_head.y()) ? 'x' : 'y'));
  const auto skin_mm = fromSkin_mm(head.skin_mm, centre_mm);
  if (skin_mm && *skin_mm > kFromSkin_mm)
    item.notes.push_back("its centre lies " + millimetres(*skin_mm) + " from the skin");
  if (by.is_handle_doubtful) judgeHandle(item, by.answers);
}

Point<Mri> toMri(const Eigen::Vector3d& p, Space space, const WorldChange& change) {
  return Point<Mri>(change.mri_T_world * inRas(p, space));
}

void judge(Item& item, const Judging& by) {
  if (item.pose) judgePose(item, by);
  for (auto* point : {&item.cortex_point_mm, &item.scalp_point_mm}) {
    if (*point) *point = toMri(**point, by.space, by.change).mm;
    if (*point && !(*point)->allFinite()) point->reset();
  }
  if (!item.place_mm) return;
  item.mri_place = toMri(*item.place_mm, by.space, by.change);
  if (!item.mri_place->mm.allFinite())
    item.refusal = "its place is no finite number";
  else if ((item.mri_place->mm - by.head.centre_mm).norm() > kReach_mm)
    item.refusal = "it lies farther than 40 cm from the middle of the head";
  if (!item.refusal.empty()) return item.mri_place.reset();
  const Eigen::Vector3d& p = item.mri_place->mm;
  if (item.kind == Kind::pulse) item.reason += formatted(" (at %.1f %.1f %.1f mm)", p.x(), p.y(), p.z());
}

/// Median distance of the poses from the skin, mm, if their axes are those of `space` and their unit is
/// `unit_mm`; less than 0: there is no pose.
double medianFromSkin_mm(const OtherFile& file, const CaseHead& head, Space space, double unit_mm) {
  std::vector<double> all_mm;
  for (const auto& item : file.items)
    if (item.pose && item.pose->allFinite() && all_mm.size() < 50) {
      const Eigen::Vector3d at = inRas(*item.pose, space).topRightCorner<3, 1>();
      if (const auto mm = fromSkin_mm(head.skin_mm, unit_mm * at)) all_mm.push_back(*mm);
    }
  if (all_mm.empty()) return -1.0;
  std::sort(all_mm.begin(), all_mm.end());
  return all_mm[all_mm.size() / 2];
}

/// Says that the poses fit the skin much better in another unit; empty if they do not.
std::string otherUnitFits(const OtherFile& file, const CaseHead& head, Space space) {
  constexpr std::pair<double, const char*> kUnits[] = {{1000, "metres"}, {10, "centimetres"}};
  const double as_is_mm = medianFromSkin_mm(file, head, space, 1);
  for (const auto& [unit_mm, name] : kUnits) {
    const double as_other_mm = medianFromSkin_mm(file, head, space, unit_mm);
    if (as_is_mm <= kNearSkin_mm || as_other_mm > kNearSkin_mm || as_other_mm > as_is_mm - kOtherSpaceBetter)
      continue;
    return formatted(
        "its poses lie %.0f mm from the skin, and %.0f mm if its lengths are %s: export it in "
        "millimetres",
        as_is_mm, as_other_mm, name);
  }
  return {};
}

/// Says that the poses fit the skin much better in the other of RAS and LPS; empty if they do not.
std::string otherSpaceFits(const OtherFile& file, const CaseHead& head, Space space) {
  const Space other = space == Space::ras ? Space::lps : Space::ras;
  const double as_is_mm = medianFromSkin_mm(file, head, space, 1);
  const double as_other_mm = medianFromSkin_mm(file, head, other, 1);
  if (as_is_mm < 0 || as_other_mm > kNearSkin_mm || as_other_mm > as_is_mm - kOtherSpaceBetter) return {};
  return formatted("as %s its poses lie %.0f mm from the skin, as %s %.0f mm", toString(space).c_str(),
                   as_is_mm, toString(other).c_str(), as_other_mm) +
         ": say with --space ras or --space lps which it is";
}

/// Places of a frame by nasion and ears that lie far from the skin: it may have other axes, or be
/// left-handed, which three points do not tell.
void notePlacesOffSkin(OtherFile& file, const CaseHead& head) {
  std::vector<double> all_mm;
  for (const auto& item : file.items)
    if (item.mri_place && all_mm.size() < 50)
      if (const auto mm = fromSkin_mm(head.skin_mm, item.mri_place->mm)) all_mm.push_back(*mm);
  if (all_mm.empty()) return;
  std::sort(all_mm.begin(), all_mm.end());
  if (const double middle_mm = all_mm[all_mm.size() / 2]; middle_mm > kFromSkin_mm)
    file.notes.push_back("half of its places lie more than " + millimetres(middle_mm) +
                         " from the skin: its frame may have other axes");
}

void refuseAll(OtherFile& file, const std::string& why) {
  for (auto& item : file.items)
    if (item.pose || item.place_mm) item.refusal = why;
}

}  // namespace

RigidTransform<Mri, Coil> soundPose(const Eigen::Matrix4d& pose, std::string* said) {
  if (!pose.allFinite()) throw Error("its pose holds something that is no finite number");
  if (pose.cwiseAbs().maxCoeff() > kFarthest_mm) throw Error("its pose lies farther away than 100 m");
  if ((pose.row(3) - Eigen::RowVector4d(0, 0, 0, 1)).cwiseAbs().maxCoeff() > 1e-6)
    throw Error("the last row of its matrix is not 0 0 0 1");
  const Eigen::Matrix3d rotation = pose.topLeftCorner<3, 3>();
  const Eigen::Vector3d lengths = rotation.colwise().norm();
  const double determinant = rotation.determinant();
  if (determinant < -0.5)
    throw Error(formatted(
        "its axes are left-handed (determinant %.2f), an error of the program that wrote it", determinant));
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(lengths[axis] - 1.0) > kLargestSkew)
      throw Error(formatted("its %c axis has the length %.3f instead of 1", "xyz"[axis], lengths[axis]));
  const Eigen::Matrix3d gram = rotation.transpose() * rotation;
  const double skew = std::max({std::abs(gram(0, 1)), std::abs(gram(0, 2)), std::abs(gram(1, 2))});
  if (skew > kLargestSkew)
    throw Error(
        formatted("its axes are %.1f deg from right angles", std::asin(std::min(1.0, skew)) * kDegPerRad));
  const double off = (gram - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (said && off > kRounded) *said = formatted("its axes were made unit and orthogonal (off by %.4f)", off);
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(rotation, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::Matrix3d nearest = svd.matrixU() * svd.matrixV().transpose();
  return {Eigen::Quaterniond(nearest), pose.topRightCorner<3, 1>()};
}

void check(OtherFile& file, const CaseHead& head, const Answers& answers, const std::optional<T1>& file_t1) {
  const bool is_template =
      file.space == Space::mni || file.space == Space::talairach || file.space == Space::other_template;
  const Space space = is_template ? file.space : answers.space.value_or(file.space);
  if (answers.space && file.space != Space::unknown && file.space != space)
    file.notes.push_back("taken as " + toString(space) + " as asked, the file says " +
                         (file.space_words.empty() ? toString(file.space) : file.space_words));
  if (answers.flips_handle) file.notes.push_back("the handle is turned by 180 degrees, as asked");
  if (const std::string fault = faultOfSpace(space, file); !fault.empty()) return refuseAll(file, fault);
  const Form form = answers.form.value_or(file.form);
  if (answers.form) file.is_form_doubtful = false;
  const WorldChange change = file.head_points        ? byHeadPoints(*file.head_points, head)
                             : file.is_of_head_frame ? byHeadFrame(answers.head_frame, head)
                             : file_t1               ? byNamedT1(*file_t1, form, head)
                                                     : byOwnWords(file, form, head);
  if (!change.refusal.empty()) return refuseAll(file, change.refusal);
  file.notes.insert(file.notes.end(), change.notes.begin(), change.notes.end());
  if (const std::string other = otherUnitFits(file, head, space); !other.empty())
    return refuseAll(file, other);
  if (!answers.space)
    if (const std::string doubt = otherSpaceFits(file, head, space); !doubt.empty())
      return refuseAll(file, doubt);
  const bool is_doubtful = file.is_handle_doubtful;
  if (is_doubtful && answers.keeps_handle) file.notes.push_back("the handle is taken as written, as asked");
  const Judging by{head, answers, space, change, is_doubtful};
  for (auto& item : file.items) judge(item, by);
  if (file.head_points || file.is_of_head_frame) notePlacesOffSkin(file, head);
}

}  // namespace facenav::interop
