#pragma once
// IcpAligner: a peer method to compare the alignment with, "icp": the 2010 paper's iterative closest point.

#include <memory>

#include "facenav/registration/aligner.h"

namespace facenav::peers {

/// Makes "icp", the paper's method (section 3, equation 1): point-to-point ICP, by PCL. As the paper writes
/// it (untrimmed, from a nearby start) it fails by 12-27 degrees on scans that end above the chin. Therefore
/// the farthest 30 % of the pairs and the pairs at the scan's cut edge are dropped, and it starts from the
/// search's rough poses.
std::unique_ptr<registration::Aligner> makeIcpAligner();

}  // namespace facenav::peers
