#include "shell/about_words.h"

#include <vtkVersion.h>

#include <Eigen/Core>
#include <QCoreApplication>
#include <QObject>
#include <QStringList>
#include <algorithm>

namespace facenav::ui {
namespace {

/// Leaves out the libraries that a build may lack (resources/cmake/facenav_packages.cmake): it knows their
/// version if it has them.
std::vector<LinkedLibrary> withoutUnused(std::vector<LinkedLibrary> all) {
  const QStringList optional{"ALSA", "Aravis", "libdc1394", "libsndfile"};
  all.erase(std::remove_if(
                all.begin(), all.end(),
                [&](const auto& each) { return optional.contains(each.name) && each.version.isEmpty(); }),
            all.end());
  return all;
}

}  // namespace

const std::vector<LinkedLibrary>& linkedLibraries() {
  static const QString kEigen =
      QString("%1.%2.%3").arg(EIGEN_WORLD_VERSION).arg(EIGEN_MAJOR_VERSION).arg(EIGEN_MINOR_VERSION);
  static const std::vector<LinkedLibrary> kAll =
      withoutUnused({{"ALSA", FACENAV_ALSA_VERSION, "LGPL-2.1-or-later", "libasound"},
                     {"Aravis", FACENAV_ARAVIS_VERSION, "LGPL-2.1-or-later", "libaravis"},
                     {"CLI11", FACENAV_CLI11_VERSION, "BSD-3-Clause", {}},
                     {"DCMTK", {}, "BSD-3-Clause", "libdcm"},
                     {"dlib", FACENAV_DLIB_VERSION, "BSL-1.0", "libdlib"},
                     {"Eigen", kEigen, "MPL-2.0", {}},
                     {"Embree", FACENAV_EMBREE_VERSION, "Apache-2.0", "libembree"},
                     {"GDCM", FACENAV_GDCM_VERSION, "BSD-3-Clause", "libgdcm"},
                     {"GIFTI and NIfTI libraries", {}, "public domain", "libnifti"},
                     {"GLib", {}, "LGPL-2.1-or-later", "libglib"},
                     {"JSON for Modern C++", FACENAV_JSON_VERSION, "MIT", {}},
                     {"LAPACK and BLAS", {}, "BSD-3-Clause", "liblapack"},
                     {"libdc1394", FACENAV_DC1394_VERSION, "LGPL-2.1-or-later", "libdc1394"},
                     {"libdeflate", {}, "MIT", "libdeflate"},
                     {"libsndfile", FACENAV_SNDFILE_VERSION, "LGPL-2.1-or-later", "libsndfile"},
                     {"libzip", {}, "BSD-3-Clause", "libzip"},
                     {"oneTBB", FACENAV_TBB_VERSION, "Apache-2.0", "libtbb"},
                     {"OpenCV", FACENAV_OPENCV_VERSION, "Apache-2.0", "libopencv"},
                     {"OpenSSL", {}, "Apache-2.0", "libcrypto"},
                     {"Point Cloud Library", FACENAV_PCL_VERSION, "BSD-3-Clause", "libpcl"},
                     {"Qt", qVersion(), "LGPL-3.0", "libQt5"},
                     {"spdlog", FACENAV_SPDLOG_VERSION, "MIT", "libspdlog"},
                     {"VTK", vtkVersion::GetVTKVersion(), "BSD-3-Clause", "libvtk"},
                     {"zlib", {}, "Zlib", "libz"}});
  return kAll;
}

QString aboutAsHtml() {
  QString html = "<h1>FaceNav</h1><p>" +
                 QObject::tr("Version %1").arg(QCoreApplication::applicationVersion().toHtmlEscaped()) +
                 "</p><p>" +
                 QObject::tr(
                     "Licence: <a href='LICENSE.md'>Apache-2.0</a>. Not a medical device: for research "
                     "and development.") +
                 "</p><h2>" + QObject::tr("Libraries") + "</h2><table cellpadding='3'>";
  for (const auto& library : linkedLibraries())
    html += "<tr><td>" + library.name + "</td><td>" + library.version.toHtmlEscaped() + "</td><td>" +
            library.licence + "</td></tr>";
  return html + "</table>";
}

}  // namespace facenav::ui
