#pragma once
// `facenav evaluate pairs`: alignment from plain pairs on photographs of real people, without truth. The face
// that one pair of cameras measures at one moment stands in for the scan; both pairs align to it at another
// moment. They share a camera, so that both state its pose against the same head: their difference is a
// measure of accuracy.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "context.h"

namespace facenav::app {

/// Two pairs of cameras that aligned to one face, at one moment.
struct FaceAgreement {
  std::string person, scanned_by, scanned, seen;  // rig and moment of the face in place of the scan; moment
  double off_deg = 0, off_mm = 0;                 // between the two poses, 80 mm behind the face
  double bound_mm = 0;                            // both stated 95 % bounds there, root of the sum of squares
  std::string refusal = {};                       // of either; empty: both aligned
};

/// `people`, `rigs`: as evaluatePairs takes them. Throws Cancelled.
std::vector<FaceAgreement> alignToMeasuredFaces(Context& context,
                                                const std::vector<std::filesystem::path>& people,
                                                const std::filesystem::path& rigs,
                                                const std::string& aligner);

/// As Markdown.
std::string facesTable(const std::vector<FaceAgreement>& agreements);

}  // namespace facenav::app
