#include <cmath>

#include "block_search.h"
#include "disparity_field.h"
#include "facenav/core/error.h"
#include "matchers.h"
#include "plane_field.h"
#ifdef FACENAV_CUDA
#include "cuda/field_cuda.h"
#endif

namespace facenav::stereo {
namespace {

constexpr double kDetailWindow_px = 2.5,
                 kDetailShrinks = 0.75;  // from each step's window to the next

class FieldMatcher : public DenseMatcher {
 public:
  FieldMatcher(const block::Kernel& search, const planes::Kernel& fit) : search_(search), fit_(fit) {}

  DisparityMap match(const Rectification& rectification, const RectifiedPair& pair,
                     const MatchOptions& options) const override {
    const MatchImages images(rectification, pair);
    PlaneField planes(images, fit_);
    planes.start(options.predicted_px.empty() ? searchBlocks(rectification, pair, search_)
                                              : options.predicted_px);
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

 private:
  block::Kernel search_;
  planes::Kernel fit_;
};

}  // namespace

std::unique_ptr<DenseMatcher> makeFieldMatcher() {
  return std::make_unique<FieldMatcher>(block::kernel(), planes::kernel());
}

#ifdef FACENAV_CUDA
bool hasCudaMatcher() { return cuda::hasDevice(); }

std::unique_ptr<DenseMatcher> makeCudaFieldMatcher() {
  if (!cuda::hasDevice()) throw Error("no CUDA device answers", {}, "use the matcher 'field'");
  return std::make_unique<FieldMatcher>(cuda::blockKernel(block::kernel()),
                                        cuda::planeKernel(planes::kernel()));
}
#else
bool hasCudaMatcher() { return false; }

std::unique_ptr<DenseMatcher> makeCudaFieldMatcher() {
  throw Error("this FaceNav was built without CUDA", {}, "use the matcher 'field'");
}
#endif

}  // namespace facenav::stereo
