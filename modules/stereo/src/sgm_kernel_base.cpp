#include "sgm_kernel.h"

namespace facenav::stereo::sgm {
namespace {
#include "sgm_kernel.inl"
}  // namespace

Step baseStep() { return step; }

}  // namespace facenav::stereo::sgm
