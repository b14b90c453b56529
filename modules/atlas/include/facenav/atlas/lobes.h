#pragma once
// Lobes: the AAL labels gathered into the regions that a person looks at ("left temporal pole",
// "cerebellum"), and carried outwards to the brain's surface and a little beyond, where labels end.

#include "facenav/atlas/brain_template.h"

namespace facenav::atlas {

class LobeMap {
 public:
  /// From the template's AAL labels, each place within 20 mm of one taking the nearest.
  explicit LobeMap(const LabelMap& aal);

  /// "left frontal lobe"; empty far from the brain.
  const std::string& at(const Point<Mni>& p) const;
  const std::vector<std::string>& names() const { return names_; }

 private:
  volume::VoxelGrid grid_;
  std::vector<std::uint8_t> region_;  // index into names_; 0: none
  std::vector<std::string> names_;
};

}  // namespace facenav::atlas
