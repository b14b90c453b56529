#pragma once
// Item: what a file of another navigator holds, before it becomes part of a case: a planned pose of the coil,
// a pulse, a landmark or an electrode. OtherFile: the items of one file, and what the file says about its
// coordinates. Readers fill them in, check.h judges them and moves them into Mri. Poses have the axes of
// FaceNav's Coil (z into the head, y away from the handle), mm.

#include <Eigen/Geometry>
#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "facenav/geometry/rigid_transform.h"

namespace facenav::interop {

enum class Kind { target, pulse, landmark, electrode };
/// Returns "target", "pulse", "landmark" or "electrode".
std::string toString(Kind kind);

/// Coordinate system that a file states. unknown: it states none, or one of which nothing is certain.
enum class Space { ras, lps, mni, talairach, other_template, unknown };
/// Returns "RAS", "LPS", "MNI", ..
std::string toString(Space space);

/// The form of the NIfTI that is meant by the coordinates. any: the file does not say, or they agree.
enum class Form { any, sform, qform };

/// Header fields that tie a file to one NIfTI by its qform.
struct QformNumbers {
  std::array<double, 3> quatern{}, offset{};
  std::array<double, 4> pixdim{1, 1, 1, 1};  // pixdim[0]: -1 for a mirrored grid
  /// Voxel-to-world map, RAS mm.
  Eigen::Affine3d affine() const;
};

/// Three points that everybody finds on a head, mm. Some files have their frame by them alone.
struct HeadPoints {
  Eigen::Vector3d left_ear, nasion, right_ear;
};

struct Item {
  Kind kind = Kind::target;
  std::string name;
  std::string where;                        // its place in the file: "line 8", "marker 2"
  std::optional<Eigen::Matrix4d> pose;      // as read, with the axes of Coil, in the file's space
  std::optional<Eigen::Vector3d> place_mm;  // of a landmark, in the file's space
  std::string reason;                       // why there is no pose: "not tracked"
  std::string time;                         // as the file's clock says it; empty: unknown
  std::optional<double> clock_s;  // the same as seconds since 1970 of a clock that shows UTC; needs a date
  std::optional<double> onset_s;  // since the start of its session, where there is no date
  std::string target, session;    // names, of a pulse
  std::optional<double> intensity_pct, didt_a_per_us, mep_uv;
  std::optional<Eigen::Vector3d> cortex_point_mm, scalp_point_mm;  // of a target, in the file's space
  std::map<std::string, std::string> values;                       // other cells of the file, by their names

  // Set by check():
  std::optional<RigidTransform<Mri, Coil>> mri_T_coil;
  std::optional<Point<Mri>> mri_place;
  std::string refusal;  // why it cannot be taken; empty: it can
  std::vector<std::string> notes;
};

struct OtherFile {
  std::string format;  // name of the format as in `--as`
  std::string words;   // "Brainsight text export, version 12"
  Space space = Space::ras;
  std::string space_words;  // the file's own words for it
  Form form = Form::any;
  bool is_clock_utc = false;              // its times name UTC; else they name no zone
  bool is_form_doubtful = false;          // the program that wrote it may have meant either form
  std::optional<QformNumbers> image;      // the NIfTI that the file belongs to
  std::optional<HeadPoints> head_points;  // in the file's coordinates, which are then of no T1
  bool is_of_head_frame = false;      // its frame is that of nasion and ears, whose axes it does not state
  bool is_handle_doubtful = false;    // y may point along the handle in place of away from it
  std::string image_words;            // the T1 that it names, in its own words
  std::filesystem::path intended_t1;  // the same, where it lies beside it
  std::vector<std::filesystem::path> parts;  // files that were read, of a folder
  std::vector<Item> items;
  std::vector<std::string> notes;
};

}  // namespace facenav::interop
