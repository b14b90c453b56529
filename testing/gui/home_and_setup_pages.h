#pragma once
// Every page of Home and of the set-up of the cameras, for tests that look at all of them.

#include <QSize>
#include <QWidget>
#include <functional>

namespace facenav::ui::fixtures {

using LookAt = std::function<void(QWidget& window, const char* page)>;

/// Goes through a treatment at home, from the chair to its end, and one that is refused.
void onEveryHomePage(const QSize& size, const LookAt& look);

/// Goes through the set-up of a pair of cameras and of the coil. Parts named "live" change all the time.
void onEverySetUpPage(const QSize& size, const LookAt& look);

}  // namespace facenav::ui::fixtures
