#pragma once
// A live pair of plain cameras (USB, V4L2, GigE through OpenCV's videoio). Both are grabbed directly one
// after the other and decoded afterwards: software synchronisation, with a skew of about a millisecond on one
// hub. Cameras with a hardware trigger need their vendor's library, in another FrameSource.

#include <memory>

#include "facenav/capture/frame_source.h"

namespace facenav::capture {

/// Opens cameras `left_index` and `right_index` at the rig's image size. Throws Error naming the camera that
/// does not open or does not deliver that size. Frames are numbered from 0; their time stamp is the steady
/// clock at the grab.
std::unique_ptr<FrameSource> openCameraPair(const cameras::StereoRig& rig, int left_index, int right_index);

}  // namespace facenav::capture
