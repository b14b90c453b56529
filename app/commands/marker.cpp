// facenav marker [--coil coil.json|NAME] [--dictionary 4x4_50 --id 7 --size 60] -o marker.svg: a page of
// markers to print.

#include <cstdio>

#include "commands/coil_option.h"
#include "commands/commands.h"
#include "facenav/coil_tracking/marker_page.h"

namespace facenav::app {

void addMarker(CLI::App& app, Context& context) {
  auto* verb =
      app.add_subcommand("marker", "a page with the coil's markers at true size, to print (SVG, A4)");
  struct MarkerRequest {
    std::string coil;
    std::filesystem::path library, output;
    coil_tracking::MarkerModel marker;
  };
  auto request = std::make_shared<MarkerRequest>();
  auto* coil = verb->add_option("--coil", request->coil,
                                "coil.json, or the name of a coil of the library; else one marker:");
  addCoilLibraryOption(*verb, request->library);
  verb->add_option("--dictionary", request->marker.dictionary, "ArUco dictionary")
      ->capture_default_str()
      ->excludes(coil);
  verb->add_option("--id", request->marker.id, "number in the dictionary")
      ->capture_default_str()
      ->excludes(coil);
  verb->add_option("--size", request->marker.size_mm, "edge of the black square, mm")
      ->capture_default_str()
      ->check(CLI::Range(5.0, 1000.0))
      ->excludes(coil);
  verb->add_option("-o,--output", request->output, "SVG to write")->required();
  verb->callback([&context, request] {
    coil_tracking::CoilModel model = coil_tracking::defaultCoil();
    model.markers = {request->marker};
    if (!request->coil.empty())
      model = coil_tracking::readCoil(
          coil_library::coilFileOf(request->coil, coil_library::coilLibrary(request->library)));
    coil_tracking::writeMarkerPage(model, request->output);
    if (!context.is_quiet)
      std::printf("%s: print at 100 %%, then check the 100 mm line\n", request->output.c_str());
  });
}

}  // namespace facenav::app
