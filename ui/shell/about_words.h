#pragma once
// About: version, commit, licence, and the libraries that the window is linked with.

#include <QString>
#include <vector>

namespace facenav::ui {

struct LinkedLibrary {
  QString name, version, licence;  // version: empty if the build does not know it
  QString file;                    // how the names of its library files begin, "libvtk"; empty: headers only
};

/// The libraries that FaceNav itself uses, by name; not those that they bring along.
const std::vector<LinkedLibrary>& linkedLibraries();
/// About as HTML; the version is that of the application (QCoreApplication).
QString aboutAsHtml();

}  // namespace facenav::ui
