#pragma once
// Lobes: groups the AAL labels into regions with common names ("left temporal pole", "cerebellum"). The
// regions extend outwards to the brain's surface and slightly beyond, where the AAL labels end.

#include "facenav/atlas/brain_template.h"

namespace facenav::atlas {

class LobeMap {
 public:
  /// Built from the template's AAL labels; each point within 20 mm of a label takes the nearest one.
  explicit LobeMap(const LabelMap& aal);

  /// Name of the region: "left frontal lobe"; empty far from the brain.
  const std::string& at(const Point<Mni>& p) const;
  const std::vector<std::string>& names() const { return names_; }

 private:
  volume::VoxelGrid grid_;
  std::vector<std::uint8_t> region_;  // index into names_; 0: none
  std::vector<std::string> names_;
};

}  // namespace facenav::atlas
