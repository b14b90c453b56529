#pragma once
// `facenav evaluate skin`: displacement of a scan's skin when a scanner's shading, a bright nose, a halo,
// pads or earphones are added (evaluation/skin_additions.h).

#include <filesystem>
#include <string>
#include <vector>

#include "context.h"
#include "facenav/surface/surface_distance.h"

namespace facenav::app {

struct SkinEvaluation {
  std::vector<std::filesystem::path> volumes;  // NIfTI
  std::vector<std::filesystem::path> labels;   // labelled heads, painted as a T1
  std::string only;                            // only additions whose name contains this
  unsigned seed = 7;
};

struct SkinRow {
  std::string volume, addition;
  surface::SurfaceDistance beyond, contact;  // skin further than 8 mm from pads; skin near them
  double contact_share = 0;                  // share of the skin
  double doubt_mm = 0;                       // given uncertainty, root mean square, of skin in contact
  double contact_rms_mm = 0;                 // its real displacement
  std::string left_out;                      // findings of the preparation, in words
};

/// Evaluates the skin. Throws Error: a volume that cannot be read, no head in it.
std::vector<SkinRow> evaluateSkin(Context& context, const SkinEvaluation& request);
std::string skinMarkdown(const std::vector<SkinRow>& rows);

}  // namespace facenav::app
