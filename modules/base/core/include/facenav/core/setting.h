#pragma once
// Setting: a number of a method that was fitted or chosen, with its unit, its range and the origin of its
// value. The settings of one method form a struct of double and int fields with their defaults:
//
//   struct BrainGrowth {
//     static constexpr const char* kModule = "segmentation";     // first part of each key
//     static constexpr const char* kSubject = "brain growth";    // heading in listings
//     double search_mm = 8;
//     template <class Self, class Visitor> static void visit(Self& self, Visitor&& visitor) {
//       visitor(kHeads("search_mm", 0, 30, "mm", "how far outside the first surface tissue is sought"),
//               self.search_mm);
//     }
//     static constexpr Evidence kHeads{Origin::fitted, "on three heads, none held out"};
//   };
//
// settings_in_force.h says how a method reads its values, settings_table.h how a file or flag changes them.

#include <string>

#include "facenav/core/field.h"

namespace facenav {
inline namespace core {

/// Origin of a setting's value.
enum class Origin {
  physics,  // a property of the scanner, camera, skin or head
  article,  // published; the evidence names it
  fitted,   // chosen by results on data; the evidence names the data, their number, and the score on other
            // data
  chosen,   // by judgement, without a fit; the evidence names what it was compared with, if anything
};
std::string toString(Origin origin);

struct Setting : Field {
  std::string unit;  // "mm", "px", "s", ..; "1" for ratios and counts
  Origin origin = Origin::chosen;
  std::string evidence;  // a sentence
};

/// Origin of the values of several settings.
struct Evidence {
  Origin origin;
  const char* words;

  Setting operator()(const char* name, double minimum, double maximum, const char* unit,
                     const char* help) const {
    return {{name, help, minimum, maximum}, unit, origin, words};
  }
};

}  // namespace core
}  // namespace facenav
