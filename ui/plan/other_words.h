#pragma once
// What the window says of files of other programs: the words of steps and interop, with the window's own
// choices in place of the options of the command line.

#include <QString>

#include "facenav/plan/import_other.h"

namespace facenav::ui {

/// "..: choose RAS or LPS under Coordinates" from "..: give --space lps or --space ras".
QString inWindowWords(const std::string& words);
QString kindWords(interop::Kind kind);
/// "comes in", "refused", ..; with the reason, if there is one.
QString fateWords(const steps::PreviewedItem& item);
/// "-37.5  -11.9  57.6" (RAS, mm); empty for an item without a place in the MRI.
QString importedPlaceWords(const interop::Item& item);
/// The place of an item in Mri, with or without a pose.
std::optional<Point<Mri>> importedPlace(const interop::Item& item);
/// A pose as Plan draws it before it is a target. Its points only place the ring and the line.
guidance::Target shownTarget(const std::string& name, const RigidTransform<Mri, Coil>& mri_T_coil);
/// Space, form and T1 that the file's coordinates were taken for. `used`: form of the case's T1 in use.
QString assumedWords(const steps::PreviewedFile& file, const std::string& used);

}  // namespace facenav::ui
