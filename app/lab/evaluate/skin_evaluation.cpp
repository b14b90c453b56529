#include "evaluate/skin_evaluation.h"

#include <algorithm>
#include <cmath>

#include "evaluate/painted_head.h"
#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/evaluation/skin_additions.h"
#include "facenav/segmentation/segmenter.h"
#include "facenav/surface/scalp_surface.h"
#include "facenav/volume/mask_morphology.h"
#include "facenav/volume/nifti.h"

namespace facenav::app {
namespace {

constexpr double kContact_mm = 8;     // skin this near to a pad is in contact
constexpr double kBelowTop_mm = 170;  // the neck further down matters neither for the coil nor for the face
constexpr double kFromEnd_mm = 8;     // distance from the end of the scan

struct Skin {
  volume::Mask head;
  surface::ScalpSurface scalp;
  std::string findings;
};

Skin skinOf(Context& context, const volume::Volume& scan) {
  auto found =
      context.registrations.head_segmenters.create(context.registrations.head_segmenters.defaultName())
          ->segment(scan, context.monitor);
  Skin skin{std::move(found.mask), {}, {}};
  skin.scalp = surface::extractScalp(scan, skin.head, context.monitor);
  for (const auto& words : found.warnings) skin.findings += (skin.findings.empty() ? "" : "; ") + words;
  return skin;
}

/// Returns true for a point far enough from the scan's ends and above the neck.
bool isJudged(const volume::VoxelGrid& grid, const Eigen::Vector3d& p_mm, double top_mm) {
  if (p_mm.z() < top_mm - kBelowTop_mm) return false;
  const Eigen::Vector3d at = grid.toVoxel(Point<Mri>(p_mm)), spacing = grid.spacing_mm();
  for (int a = 0; a < 3; ++a)
    if (at[a] * spacing[a] < kFromEnd_mm || (grid.size[a] - 1 - at[a]) * spacing[a] < kFromEnd_mm)
      return false;
  return true;
}

SkinRow comparedSkin(const Skin& clean, const Skin& found, const volume::Mask& pads) {
  const std::vector<float> moved_mm = surface::signedDistances_mm(clean.scalp.mesh, found.scalp.mesh);
  const std::vector<float> pad_mm = volume::distanceTo(pads);
  const surface::ClosestPoint closest(found.scalp.mesh);
  double top_mm = -1e9, squares = 0, doubts = 0;
  for (const auto& p : clean.scalp.mesh.vertices_mm) top_mm = std::max(top_mm, p.z());
  std::vector<float> beyond, contact;
  for (std::size_t v = 0; v < moved_mm.size(); ++v) {
    const Eigen::Vector3d& p = clean.scalp.mesh.vertices_mm[v];
    if (!isJudged(pads.grid, p, top_mm)) continue;
    const Eigen::Vector3i at = pads.grid.toVoxel(Point<Mri>(p)).array().round().cast<int>();
    if (pad_mm[pads.grid.index(at.x(), at.y(), at.z())] >= kContact_mm) {
      beyond.push_back(moved_mm[v]);
      continue;
    }
    contact.push_back(moved_mm[v]);
    squares += moved_mm[v] * moved_mm[v];
    const auto& triangle = found.scalp.mesh.triangles[std::size_t(closest.nearest(Point<Mri>(p)).triangle)];
    doubts += std::pow(found.scalp.doubt_mm[std::size_t(triangle[0])], 2);
  }
  SkinRow row;
  row.beyond = surface::summarise(beyond), row.contact = surface::summarise(contact);
  const double count = std::max<double>(1, double(contact.size()));
  row.contact_share = double(contact.size()) / std::max<double>(1, double(contact.size() + beyond.size()));
  row.contact_rms_mm = std::sqrt(squares / count), row.doubt_mm = std::sqrt(doubts / count);
  row.left_out = found.findings;
  return row;
}

void addRows(Context& context, const SkinEvaluation& request, const std::string& name,
             const volume::Volume& scan, std::vector<SkinRow>& rows) {
  const Skin clean = skinOf(context, scan);
  const evaluation::CleanScan made(scan, clean.head, clean.scalp.mesh);
  for (const auto& addition : evaluation::skinAdditions()) {
    const bool is_halo_alone = addition.halo > 0 && addition.pad_behind <= 0;
    if (addition.name.find(request.only) == std::string::npos || (is_halo_alone && made.isAirErased()))
      continue;
    context.monitor.report("evaluate skin: " + name + ", " + addition.name, 0.5);
    const auto added = made.with(addition, request.seed);
    rows.push_back(comparedSkin(clean, skinOf(context, added.scan), added.pads));
    rows.back().volume = name, rows.back().addition = addition.name;
  }
}

}  // namespace

std::vector<SkinRow> evaluateSkin(Context& context, const SkinEvaluation& request) {
  std::vector<SkinRow> rows;
  for (const auto& path : request.volumes)
    addRows(context, request, path.filename().string(), volume::readNifti(path).volume, rows);
  for (const auto& path : request.labels) {
    const auto painted = paintedHead(path);
    if (!painted)
      throw Error("there are no label statistics beside this head", path.string(),
                  "give a labelled head of the shared data");
    addRows(context, request, "head " + path.stem().stem().string(), painted->scan, rows);
  }
  return rows;
}

std::string skinMarkdown(const std::vector<SkinRow>& rows) {
  std::string text =
      "| scan | added | skin moved: median mm | 95 % mm | in contact: share % | median mm | rms mm | stated "
      "mm | "
      "findings |\n|---|---|---|---|---|---|---|---|---|\n";
  for (const auto& row : rows)
    text += formatted("| %s | %s | %.3f | %.3f | %.0f | %.3f | %.2f | %.2f | %s |\n", row.volume.c_str(),
                      row.addition.c_str(), row.beyond.median_mm, row.beyond.p95_mm, 100 * row.contact_share,
                      row.contact.median_mm, row.contact_rms_mm, row.contact_share > 0 ? row.doubt_mm : 0.0,
                      row.left_out.c_str());
  return text;
}

}  // namespace facenav::app
