#pragma once
// Reads the chessboard pairs for `facenav calibrate`: file names or globs of both sides -> images, paired by
// number.

#include <string>
#include <vector>

#include "facenav/cameras/calibrate.h"

namespace facenav::capture {

/// Reads the pairs. `left` and `right` are lists of files and globs ("left*.jpg"), expanded here and sorted
/// by the number in the name. Throws Error: a glob without a match, counts or numbers that differ, an image
/// that cannot be read.
std::vector<cameras::CalibrationPair> readCalibrationImages(const std::vector<std::string>& left,
                                                            const std::vector<std::string>& right);

}  // namespace facenav::capture
