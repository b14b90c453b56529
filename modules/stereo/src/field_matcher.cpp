#include <cmath>

#include "block_search.h"
#include "disparity_field.h"
#include "matchers.h"
#include "plane_field.h"

namespace facenav::stereo {
namespace {

class FieldMatcher : public DenseMatcher {
 public:
  DisparityMap match(const Rectification& rectification, const RectifiedPair& pair,
                     const MatchOptions& options) const override {
    const MatchImages images(rectification, pair);
    PlaneField planes(images);
    planes.start(options.predicted_px.empty() ? searchBlocks(rectification, pair) : options.predicted_px);
    for (int i = 0; i < options.steps; ++i) planes.step(options.window_sigma_px);
    if (!options.details) return planes.map(options);
    DisparityField field(images);
    field.start(planes.nodes());
    field.step(2.5);
    for (int i = 0; i < options.details; ++i) field.addDetail(2.5 * std::pow(0.75, i + 1));
    return field.map(options);
  }
};

}  // namespace

std::unique_ptr<DenseMatcher> makeFieldMatcher() { return std::make_unique<FieldMatcher>(); }

}  // namespace facenav::stereo
