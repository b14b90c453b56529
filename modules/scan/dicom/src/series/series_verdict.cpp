#include "series_verdict.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "bright_and_dark.h"
#include "duplicates.h"
#include "facenav/core/number_text.h"
#include "facenav/geometry/rotation.h"
#include "facenav/volume/voxel_size.h"
#include "pixels/pixel_decoder.h"

namespace facenav::dicom {
namespace {

constexpr double kMostVoxels = 1e9;
constexpr const char* kFitByHeader =
    "voxels and field of view fit navigation; the face is judged when it is prepared";

bool startsWith(const std::string& text, const char* start) { return text.rfind(start, 0) == 0; }

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return text;
}

/// Problem of objects that are not images of a volume, by SOP class (PS3.4 B.5) or modality.
std::string objectProblem(const SliceHeader& header) {
  const std::string root = "1.2.840.10008.5.1.4.1.1.";
  const std::string kind =
      startsWith(header.sop_class, root.c_str()) ? header.sop_class.substr(root.size()) : "";
  if (header.sop_class == "1.2.840.10008.1.3.10") return "DICOMDIR, a table of contents";
  if (startsWith(kind, "88.") || header.modality == "SR") return "structured report, no image";
  if (startsWith(kind, "104.")) return kind == "104.1" ? "PDF document, no image" : "document, no image";
  if (kind == "481.2" || header.modality == "RTDOSE") return "radiation dose, no anatomical image";
  if (kind == "481.3" || header.modality == "RTSTRUCT") return "radiotherapy structures, no image";
  if (startsWith(kind, "481.") || header.modality == "RTPLAN") return "radiotherapy plan or record, no image";
  if (startsWith(kind, "11.")) return "presentation state, no image";
  if (kind == "66") return "raw data, no image";
  if (startsWith(kind, "66.")) return "segmentation or registration object, no anatomical image";
  if (kind == "4.2") return "spectroscopy, no image";
  if (startsWith(kind, "9.")) return "waveform, no image";
  if (startsWith(kind, "77.")) return "photograph, no volume";
  // Some exports declare volumes as secondary captures; those at least carry a position.
  const bool is_capture = kind == "7" || startsWith(kind, "7.");
  if (is_capture && !(!header.images.empty() && header.images[0].position_lps_mm))
    return "secondary capture (a screenshot), no volume";
  if (!header.layout.has_pixels) return "holds no image";
  return {};
}

struct Problem {
  SeriesProblem kind = SeriesProblem::none;
  std::string words;
};

Problem imageProblem(const SliceHeader& header) {
  if (const auto words = objectProblem(header); !words.empty()) return {SeriesProblem::no_volume, words};
  if (const auto words = voxelProblem(header); !words.empty()) return {SeriesProblem::unreadable, words};
  if (header.modality.empty()) return {SeriesProblem::no_volume, "modality unknown"};
  if (header.modality != "MR" && header.modality != "CT")
    return {SeriesProblem::no_volume, "modality " + header.modality + " is neither MR nor CT"};
  if (header.is_mosaic) return {SeriesProblem::no_volume, "mosaic: many slices tiled into one image"};
  if (header.image_type.find("LOCALIZER") != std::string::npos)
    return {SeriesProblem::no_volume, "localizer"};
  if (header.voxels.frames > 1 && header.images.size() < 2)
    return {SeriesProblem::geometry, "multi-frame image without a position for each frame"};
  if (header.layout.is_truncated) return {SeriesProblem::damaged, "pixel data is cut off"};
  return {};
}

bool hasProblem(const SeriesInfo& info) { return info.problem_kind != SeriesProblem::none; }

void setProblem(SeriesInfo& info, const Problem& problem, const std::filesystem::path& file) {
  if (problem.kind == SeriesProblem::none || hasProblem(info)) return;
  info.problem_kind = problem.kind;
  info.problem = problem.words;
  info.problem_file = file;
}

void describeGeometry(SeriesInfo& info, const volume::VoxelGrid& grid) {
  info.spacing_mm = grid.spacing_mm();
  const Eigen::Matrix3d linear = grid.mri_from_voxel.linear();
  info.extent_mm = linear.cwiseAbs() * Eigen::Vector3d(grid.size[0], grid.size[1], grid.size[2]);
}

std::string planeOf(const ImagePlace& place) {
  if (!place.axes_lps) return "";
  const Eigen::Vector3d normal = place.axes_lps->col(0).cross(place.axes_lps->col(1)).normalized();
  int axis = 0;
  const double cosine = normal.cwiseAbs().maxCoeff(&axis);
  constexpr const char* kPlanes[] = {"sagittal", "coronal", "axial"};
  constexpr double kOblique_deg = 5;
  return std::string(kPlanes[axis]) + (cosine < std::cos(kOblique_deg * kRadPerDeg) ? " oblique" : "");
}

void collectFiles(SeriesInfo& info, const std::vector<SliceHeader>& headers,
                  const std::vector<ImageRef>& images) {
  std::map<int, std::vector<int>> frames_of;
  for (const ImageRef image : images) frames_of[image.header].push_back(image.frame);
  bool is_whole = true;
  for (auto& [header, frames] : frames_of) {
    std::sort(frames.begin(), frames.end());
    info.files.push_back(headers[std::size_t(header)].file);
    info.frames.push_back(frames);
    is_whole &= frames.size() == headers[std::size_t(header)].images.size();
  }
  if (is_whole) info.frames.clear();
}

/// Returns the fault; or "localizer" for images in several directions, or a single one, with that
/// description.
Problem stackProblem(const StackFault& fault, const SeriesInfo& info, const SeriesGroup& group) {
  const std::string words = lower(info.description);
  for (const char* word : {"localizer", "localiser", "scout", "survey", "pilot", "loc"})
    if (group.images.size() < 40 && words.find(word) != std::string::npos &&
        (group.is_scattered || group.images.size() == 1))
      return {SeriesProblem::no_volume, "localizer"};
  if (group.is_scattered)
    return {SeriesProblem::no_volume, "images in many directions (projections or a localizer), no volume"};
  return {fault.kind, fault.what};
}

/// Drops duplicates; reports different images at one place.
void settleCoincident(SeriesInfo& info, const std::vector<SliceHeader>& headers, const SliceStack& stack) {
  if (stack.coincident.empty() || hasProblem(info)) return;
  for (const auto& [kept, other] : stack.coincident) {
    if (isSameImage(headers, kept, other)) continue;
    const std::size_t images = stack.order.size() + stack.coincident.size();
    const auto& a = headers[std::size_t(kept.header)].file;
    const auto& b = headers[std::size_t(other.header)].file;
    if (images % stack.order.size() == 0)
      setProblem(info,
                 {SeriesProblem::several_volumes, "holds " + std::to_string(images / stack.order.size()) +
                                                      " volumes of the same place (4-D)"},
                 b);
    else
      setProblem(info,
                 {SeriesProblem::geometry,
                  "two different images lie at the same place (" + a.filename().string() + ")"},
                 b);
    return;
  }
  const std::size_t dropped = stack.coincident.size();
  info.notes.push_back(std::to_string(dropped) + (dropped == 1 ? " duplicate image" : " duplicate images") +
                       " dropped");
}

/// The part of Image Type for the group's first image; frames of enhanced files may state none.
ImageKind kindOfImage(const SliceHeader& header, const ImagePlace& place) {
  if (header.is_annotated) return ImageKind::annotated;
  return kindOf(place.kind.empty() ? header.image_type : place.kind, header.description);
}

}  // namespace

void judgeFitness(SeriesInfo& info) {
  std::vector<std::string> against;
  if (isMap(info.kind))
    against.push_back(withArticle(info.kind) + ", not a T1-weighted image");
  else if (isWithoutSkin(info.kind))
    against.push_back(withArticle(info.kind) + ", not a magnitude");
  else if (info.kind == ImageKind::localizer || info.kind == ImageKind::annotated)
    against.push_back(withArticle(info.kind));
  else if (info.kind == ImageKind::signed_or_uniform)
    against.push_back(
        "a phase image, a real part or an MP2RAGE UNI: its air lies in the middle of its values");
  if (info.modality == "CT") against.push_back("CT: no brain model, the scalp only");
  if (info.modality == "MR" && against.empty() && info.contrast != "T1")
    against.push_back(info.contrast.empty() ? "T1 weighting not certain"
                                            : info.contrast + "-weighted, not T1");
  const double coarsest_mm = info.spacing_mm.maxCoeff();
  if (const auto size = volume::voxelSizeOf(coarsest_mm); size != volume::VoxelSize::fine)
    against.push_back(formatted(size == volume::VoxelSize::coarse
                                    ? "voxels up to %.3g mm (1.2 mm or finer is needed)"
                                    : "voxels up to %.3g mm, too coarse (1.2 mm or finer is needed)",
                                coarsest_mm));
  if (info.extent_mm.x() < 120 || info.extent_mm.y() < 150 || info.extent_mm.z() < 150)
    against.push_back("does not cover the whole head");
  if (info.missing_images > 0)
    against.push_back(formatted("%d of the %d images that its headers speak of are not here",
                                info.missing_images, info.stated_images));
  info.is_fit_for_navigation = against.empty();
  info.fitness = against.empty() ? kFitByHeader : "";
  for (const auto& reason : against) info.fitness += (info.fitness.empty() ? "" : "; ") + reason;
}

namespace {

void addNotes(SeriesInfo& info, const SliceHeader& header) {
  const std::string& syntax = header.layout.transfer_syntax;
  for (const char* lossy : {".4.50", ".4.51", ".4.81", ".4.91"})
    if (syntax == std::string("1.2.840.10008.1.2") + lossy)
      info.notes.push_back("compressed, possibly with loss");
  if (isStoredInverted(header))
    info.notes.push_back("stored with bright and dark exchanged (MONOCHROME1): read with dark air");
  if (header.has_scattered_identity)
    info.notes.push_back(
        "every image names another patient, as some anonymisers write it: taken as one patient, since all "
        "share one series UID");
  info.has_contrast_agent = !header.contrast_agent.empty();
  if (info.has_contrast_agent) info.notes.push_back("with contrast agent");
  if (info.kind == ImageKind::uniform)
    info.notes.push_back(std::string(inWords(info.kind)) + ": T1-weighted, its air may be noise");
  if (info.kind == ImageKind::inversion) info.notes.push_back(inWords(info.kind));
}

}  // namespace

const char* idOf(SeriesProblem problem) {
  switch (problem) {
    case SeriesProblem::none:
      return "";
    case SeriesProblem::no_volume:
      return "no_volume";
    case SeriesProblem::unreadable:
      return "unreadable";
    case SeriesProblem::damaged:
      return "damaged";
    case SeriesProblem::geometry:
      return "geometry";
    case SeriesProblem::single_slice:
      return "single_slice";
    case SeriesProblem::several_volumes:
      return "several_volumes";
    case SeriesProblem::too_large:
      return "too_large";
  }
  return "";
}

std::string contrastOf(const SliceHeader& header, double echo_time_ms) {
  if (header.modality == "CT") return "CT";
  const std::string words = lower(header.description + " " + header.sequence);
  const auto has = [&](std::initializer_list<const char*> list) {
    return std::any_of(list.begin(), list.end(),
                       [&](const char* w) { return words.find(w) != std::string::npos; });
  };
  if (has({"flair", "dark-fluid", "dark fluid"}) && !has({"t1"})) return "FLAIR";
  if (has({"dwi", "dti", "diff", "adc", "tracew", "ep2d"})) return "diffusion or EPI";
  if (has({"bold", "fmri", "resting"})) return "functional";
  if (has({"tof", "angio", "mra", "mip"})) return "angiography";
  if (has({"swi", "swan", "t2*", "t2star"})) return "T2*";
  if (has({"mprage", "mp-rage", "mp2rage", "t1", "bravo", "spgr", "mpr ", "ir-fspgr"})) return "T1";
  if (has({"t2", "tse", "haste", "ciss", "fiesta"})) return "T2";
  const double te = echo_time_ms, tr = header.repetition_time_ms, ti = header.inversion_time_ms;
  if (te <= 0 || tr <= 0) return "";
  if (te < 15 && (tr < 60 || (ti > 400 && ti < 1400) || (tr < 900 && ti <= 0))) return "T1";
  if (te >= 60) return ti > 1500 ? "FLAIR" : "T2";
  if (te < 40 && tr > 1800 && ti <= 0) return "PD";
  return "";
}

namespace {

/// What the headers say of the group, before its images are stacked.
SeriesInfo startFromHeaders(const std::vector<SliceHeader>& headers, const SeriesGroup& group) {
  const ImageRef first_image = group.images[0];
  const SliceHeader& first = headers[std::size_t(first_image.header)];
  const ImagePlace& place = placeOf(headers, first_image);
  SeriesInfo info;
  info.series_uid = info.id = first.series_uid;
  info.study_uid = first.study_uid;
  if (group.joined) {
    info.joined = group.joined;
    info.series_uid = info.id = group.joined->series_uid;
    info.study_uid = group.joined->study_uid;
  }
  info.patient = first.patient_number;
  info.description = first.description;
  info.modality = first.modality;
  info.date = first.date;
  info.part = group.part;
  info.is_magnitude_part = group.is_magnitude_part;
  info.kind = kindOfImage(first, place);
  constexpr std::size_t kMostOfALocalizer = 40;
  if (info.kind == ImageKind::localizer && group.images.size() >= kMostOfALocalizer)
    info.kind = ImageKind::magnitude;
  info.contrast = isMap(info.kind) || isWithoutSkin(info.kind) ? inWords(info.kind)
                                                               : contrastOf(first, place.echo_time_ms);
  info.series_number = first.series_number;
  info.rows = first.voxels.rows;
  info.columns = first.voxels.columns;
  info.slices = int(group.images.size());
  info.plane = planeOf(place);
  return info;
}

}  // namespace

SeriesInfo describeGroup(const std::vector<SliceHeader>& headers, const SeriesGroup& group) {
  const SliceHeader& first = headers[std::size_t(group.images[0].header)];
  SeriesInfo info = startFromHeaders(headers, group);
  for (const ImageRef image : group.images) {
    const SliceHeader& header = headers[std::size_t(image.header)];
    setProblem(info, imageProblem(header), header.file);
    if (hasProblem(info)) break;
  }
  std::vector<ImageRef> used = group.images;
  if (!hasProblem(info)) {
    const SliceStack stack = stackSlices(headers, group.images);
    if (!stack.order.empty()) {
      used = stack.order;
      settleCoincident(info, headers, stack);
    }
    if (stack.fault) setProblem(info, stackProblem(*stack.fault, info, group), stack.fault->file);
    if (!stack.note.empty()) info.notes.push_back(stack.note);
    if (group.stacks > 1)
      info.notes.push_back(
          formatted("its %d stacks (Stack ID) were joined: together they are one even volume", group.stacks));
    if (!stack.fault) describeGeometry(info, stack.grid);
    if (double(info.rows) * info.columns * double(used.size()) > kMostVoxels)
      setProblem(info, {SeriesProblem::too_large, "too large"}, first.file);
    if (!hasProblem(info)) info.slices = int(used.size());
  }
  if (hasProblem(info)) used = group.images;
  const ImageRef middle = used[used.size() / 2];
  if (headers[std::size_t(middle.header)].layout.has_pixels) {
    info.thumbnail_file = headers[std::size_t(middle.header)].file;
    info.thumbnail_frame = middle.frame;
  }
  collectFiles(info, headers, used);
  info.is_loadable = !hasProblem(info);
  addNotes(info, first);
  if (info.is_loadable) judgeFitness(info);
  return info;
}

double navigationScore(const SeriesInfo& info) {
  if (!info.is_loadable || info.modality != "MR") return 0;
  if (isMap(info.kind) || isWithoutSkin(info.kind) || info.kind == ImageKind::localizer ||
      info.kind == ImageKind::annotated)
    return 0;
  if (!info.contrast.empty() && info.contrast != "T1") return 0;
  const double coarsest_mm = info.spacing_mm.maxCoeff();
  if (volume::voxelSizeOf(coarsest_mm) == volume::VoxelSize::too_coarse || info.extent_mm.minCoeff() < 100)
    return 0;
  double score = 100 - 20 * std::max(0.0, coarsest_mm - 0.8);
  if (info.contrast == "T1") score += 40;
  if (info.is_fit_for_navigation) score += 40;
  if (info.extent_mm.z() >= 200) score += 10;  // includes chin and neck: the whole face
  if (info.has_contrast_agent) score -= 15;
  if (!info.part.empty() && !info.is_magnitude_part) score -= 25;
  // A T1-weighted magnitude comes before an MP2RAGE UNI, whose air may be noise, and that before its
  // inversions.
  if (info.kind == ImageKind::uniform) score -= 60;
  if (info.kind == ImageKind::inversion) score -= 70;
  if (info.kind == ImageKind::signed_or_uniform) score -= 80;
  return score;
}

}  // namespace facenav::dicom
