#pragma once
// Field: the description of one option. An algorithm's options struct names each option once, in a static
// `visit(self, visitor)` that calls visitor(Field{...}, self.member). JSON, CLI flags and the GUI form are
// generated from it.
//
//   struct IcpOptions {
//     double trim_fraction = 0.8;
//     template <class Self, class Visitor> static void visit(Self& self, Visitor&& visitor) {
//       visitor(Field{"trim_fraction", "share of the closest pairs kept", 0.1, 1.0}, self.trim_fraction);
//     }
//   };

#include <limits>
#include <string>

namespace facenav {
inline namespace core {

struct Field {
  std::string name;
  std::string help;
  double minimum = -std::numeric_limits<double>::infinity();
  double maximum = std::numeric_limits<double>::infinity();
};

}  // namespace core
}  // namespace facenav
