#pragma once
// The colours of all pictures and of the window: dark, blue and orange (safe for colour blindness), contrast
// of text on panel above 4.5:1. Words and shapes show the state (SCREENS.md); colour only repeats it.

#include <array>

namespace facenav::scene::palette {

using Rgb = std::array<double, 3>;  // 0..1

constexpr Rgb kBackground{0.043, 0.051, 0.063};
constexpr Rgb kBackgroundTop{0.094, 0.114, 0.141};
constexpr Rgb kPanel{0.082, 0.098, 0.122};
constexpr Rgb kLine{0.20, 0.235, 0.28};
constexpr Rgb kText{0.93, 0.945, 0.96};
constexpr Rgb kMuted{0.62, 0.67, 0.72};
constexpr Rgb kBlue{0.33, 0.70, 1.00};    // tracked, on target
constexpr Rgb kOrange{1.00, 0.63, 0.20};  // adjust, caution, target
constexpr Rgb kLost{0.60, 0.62, 0.65};    // lost
constexpr Rgb kSkin{0.96, 0.80, 0.70};
constexpr Rgb kCoil{0.84, 0.88, 0.93};

}  // namespace facenav::scene::palette
