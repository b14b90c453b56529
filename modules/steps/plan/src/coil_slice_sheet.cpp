#include "facenav/plan/coil_slice_sheet.h"

#include <algorithm>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/guidance/handle.h"
#include "facenav/pictures/titled_row.h"
#include "facenav/scene/coil_slices.h"

namespace facenav::steps {

std::optional<double> alignedBound95_mm(const casefile::CaseStore& store, const guidance::Target& target) {
  try {
    const auto alignment = store.alignment();
    if (!alignment) return std::nullopt;
    // The stored bounds include errors that the uncertainty lacks: a camera that may have turned, an
    // uncertain skin.
    double bound_mm = 0;
    const auto& stored = alignment->predicted_tre_p95_mm;
    if (const auto own = stored.find(target.name); own != stored.end())
      bound_mm = own->second;
    else  // planned after the alignment
      for (const auto& [ignored, other_mm] : stored) bound_mm = std::max(bound_mm, other_mm);
    if (alignment->uncertainty)
      bound_mm = std::max(
          bound_mm, alignment->uncertainty->errorBound_mm(alignment->camera_T_mri, target.cortex_point));
    return bound_mm > 0 ? std::optional(bound_mm) : std::nullopt;
  } catch (const Error&) {
    return std::nullopt;
  }
}

RgbImage coilSliceSheet(const scene::SliceScene& scene, const guidance::Target& target,
                        const guidance::CoilPlate& plate, std::optional<double> bound95_mm) {
  constexpr int kWidth_px = 560, kHeight_px = 520;
  scene::SliceScene shown = scene;
  shown.targets = {target};
  shown.active_target = target.name;
  const scene::SlicedCoil coil{target.mri_T_target.reframe<Mri, Coil>(), plate,
                               bound95_mm};  // the planned coil
  const auto slice = [&](scene::CoilCut cut) {
    return coilSlicePicture(shown, coil, cut, coilPlane(coil.mri_T_coil, cut, kWidth_px, kHeight_px));
  };
  const std::string bound =
      bound95_mm && *bound95_mm > 0 ? formatted("; ring: 95 %% within %.1f mm", *bound95_mm) : "";
  return pictures::titledRow(
      {{target.name + formatted(": along the handle (on the left), cortex %.0f mm below the scalp",
                                guidance::cortexDepth_mm(target)),
        slice(scene::CoilCut::along_handle)},
       {"across the handle, as seen from it; a tick is 10 mm" + bound,
        slice(scene::CoilCut::across_handle)}});
}

RgbImage mapScale(const casefile::OverlayEntry& entry) {
  constexpr int kWidth_px = 560, kHeight_px = 14;
  RgbImage bars[2] = {RgbImage(kWidth_px, kHeight_px), RgbImage(kWidth_px, kHeight_px)};
  for (int sign = 0; sign < 2; ++sign)
    for (int v = 0; v < kHeight_px; ++v)
      for (int u = 0; u < kWidth_px; ++u) {
        const double size = entry.threshold + (entry.full - entry.threshold) * u / (kWidth_px - 1);
        const auto colour = scene::mapColour(sign == 0 ? size : -size, entry.threshold, entry.full);
        for (int c = 0; c < 3; ++c)
          bars[sign].pixel(u, v)[c] = std::uint8_t(255 * colour[std::size_t(c)] + 0.5);
      }
  const std::string unit = entry.unit.empty() ? "" : " " + entry.unit;
  const auto title = [&](const char* sign) {
    return entry.name + formatted(": %s%.3g to %s%.3g", sign, entry.threshold, sign, entry.full) + unit;
  };
  return pictures::titledRow({{title("-"), bars[1]}, {title("+"), bars[0]}});
}

}  // namespace facenav::steps
