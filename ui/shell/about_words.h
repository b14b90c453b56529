#pragma once
// About: version, build, licence, and the parts that others made (core/licences.h).

#include <QString>

namespace facenav::ui {

/// About as HTML; the version is that of the application (QCoreApplication).
QString aboutAsHtml();

}  // namespace facenav::ui
