#include "facenav/head_tracking/loss_detail.h"

namespace facenav::head_tracking {

std::string toString(LossDetail detail) {
  switch (detail) {
    case LossDetail::unknown:
      return "";
    case LossDetail::not_found:
      return "not_found";
    case LossDetail::covered:
      return "covered";
    case LossDetail::too_far:
      return "too_far";
    case LossDetail::blurred:
      return "blurred";
    case LossDetail::one_camera:
      return "one_camera";
    case LossDetail::doubtful:
      return "doubtful";
    case LossDetail::frozen:
      return "frozen";
    case LossDetail::no_picture:
      return "no_picture";
    case LossDetail::swapped:
      return "swapped";
    case LossDetail::other_face:
      return "other_face";
    case LossDetail::out_of_step:
      return "out_of_step";
    case LossDetail::cameras_moved:
      return "cameras_moved";
    case LossDetail::cameras_disagree:
      return "cameras_disagree";
  }
  return "";
}

}  // namespace facenav::head_tracking
