#include <cmath>

#include "block_search.h"
#include "disparity_field.h"
#include "matchers.h"
#include "plane_field.h"

namespace facenav::stereo {
namespace {

constexpr double kDetailWindow_px = 2.5,
                 kDetailShrinks = 0.75;  // from each step's window to the next

class FieldMatcher : public DenseMatcher {
 public:
  DisparityMap match(const Rectification& rectification, const RectifiedPair& pair,
                     const MatchOptions& options) const override {
    const MatchImages images(rectification, pair);
    PlaneField planes(images);
    planes.start(options.predicted_px.empty() ? searchBlocks(rectification, pair) : options.predicted_px);
    for (int i = 0; i < options.steps; ++i) planes.step(options.window_sigma_px);
    for (int i = 0; i < options.growths; ++i) planes.grow(options.window_sigma_px, options);
    if (!options.details) return planes.map(options);
    DisparityField field(images);
    field.start(planes.nodes());
    field.step(kDetailWindow_px);
    for (int i = 1; i <= options.details; ++i)
      field.addDetail(kDetailWindow_px * std::pow(kDetailShrinks, i));
    return field.map(options);
  }

  bool startsFromPrediction() const override { return true; }
};

}  // namespace

std::unique_ptr<DenseMatcher> makeFieldMatcher() { return std::make_unique<FieldMatcher>(); }

}  // namespace facenav::stereo
