#pragma once
// `facenav evaluate pairs`: alignment from plain pairs on photographs of real people, without truth. The face
// that one pair of cameras measures at one moment replaces the scan; two pairs align to it at another moment.
// They share a camera, so both give its pose against the same head: their difference is a measure of
// accuracy.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "context.h"

namespace facenav::app {

/// Two pairs of cameras that aligned to one face, at one moment.
struct FaceAgreement {
  std::string person, scanned_by, scanned, seen;  // rig and moment of the face that replaces the scan; moment
                                                  // of the alignment
  double off_deg = 0, off_mm = 0;                 // difference between the two poses, 80 mm behind the face
  double bound_mm = 0;                            // root of the sum of squares of both 95 % bounds there
  std::string refusal = {};                       // refusal of either; empty if both aligned
};

/// Compares the alignments. `people`, `rigs`: as for evaluatePairs. Throws Cancelled.
std::vector<FaceAgreement> alignToMeasuredFaces(Context& context,
                                                const std::vector<std::filesystem::path>& people,
                                                const std::filesystem::path& rigs,
                                                const std::string& aligner);

/// Formats the results as Markdown.
std::string facesTable(const std::vector<FaceAgreement>& agreements);

}  // namespace facenav::app
