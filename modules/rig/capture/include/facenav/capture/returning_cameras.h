#pragma once
// Live cameras that may be gone for a while and come back in the middle of a session (a cable, a hub without
// power). While one is away, frames without pictures report it (StereoFrame::absence), and the cameras are
// opened again as soon as possible. A session (session/session.h) reads them.

#include <functional>
#include <memory>

#include "facenav/capture/frame_source.h"

namespace facenav::capture {

/// `open` is called at once, and again to reopen the cameras. Frame numbers and times continue over a gap.
/// Throws what the first `open` throws; next() throws errors that plugging in does not solve (pictures of
/// another size).
std::unique_ptr<FrameSource> makeReturningCameras(std::function<std::unique_ptr<FrameSource>()> open);

}  // namespace facenav::capture
