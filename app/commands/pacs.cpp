// facenav pacs echo|find|get|store: the hospital's archive over the DICOM network. Patients are shown only on
// request.

#include "facenav/pacs/pacs.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "commands/commands.h"
#include "typed_values.h"

namespace facenav::app {
namespace {

struct PacsRequest {
  pacs::PacsNode node;
  pacs::Tls tls;
  pacs::PacsQuery query;
  std::string study_uid, series_uid, method = "automatic";
  std::filesystem::path folder;
  bool is_json = false, shows_patients = false;

  pacs::PacsNode connection() const {
    pacs::PacsNode whole = node;
    if (!tls.trusted_certificate.empty()) whole.tls = tls;
    return whole;
  }
};

void addNode(CLI::App* verb, const std::shared_ptr<PacsRequest>& request) {
  pacs::PacsNode& node = request->node;
  verb->add_option("--host", node.host, "the archive's name or address")->required();
  verb->add_option("--port", node.port, "its DICOM port")->check(CLI::Range(1, 65535))->capture_default_str();
  verb->add_option("--title", node.title, "its application entity title")->required();
  verb->add_option("--own-title", node.own_title, "ours, as entered there")->capture_default_str();
  verb->add_option("--own-port", node.own_port, "where it sends to on C-MOVE")
      ->check(CLI::Range(1, 65535))
      ->capture_default_str();
  verb->add_option("--timeout", node.timeout_s, "s")->check(CLI::Range(1, 3600))->capture_default_str();
  verb->add_option("--tls-trust", request->tls.trusted_certificate,
                   "use TLS: PEM certificate of the archive, or of who signed it");
  verb->add_option("--tls-certificate", request->tls.certificate, "our own, where the archive asks for one");
  verb->add_option("--tls-key", request->tls.key, "its key");
}

nlohmann::ordered_json toJson(const pacs::PacsSeries& series, bool shows_patient) {
  nlohmann::ordered_json json{{"study_uid", series.study_uid},
                              {"series_uid", series.series_uid},
                              {"date", series.date},
                              {"study_description", series.study_description},
                              {"description", series.description},
                              {"modality", series.modality},
                              {"images", series.images}};
  if (shows_patient) json["patient_id"] = series.patient_id, json["patient_name"] = series.patient_name;
  return json;
}

void print(const pacs::PacsSeries& series, bool shows_patient) {
  const std::string patient = shows_patient ? series.patient_id + "  " + series.patient_name + "  " : "";
  std::printf("%s%s  %-3s %5d images  %s: %s\n    --study %s --series %s\n", patient.c_str(),
              series.date.c_str(), series.modality.c_str(), series.images, series.study_description.c_str(),
              series.description.c_str(), series.study_uid.c_str(), series.series_uid.c_str());
}

void addEcho(CLI::App& pacs_verb, Context& context) {
  auto* verb = pacs_verb.add_subcommand("echo", "is the archive there, and does it know us (C-ECHO)");
  const auto request = std::make_shared<PacsRequest>();
  addNode(verb, request);
  verb->callback([&context, request] {
    pacs::echo(request->connection());
    if (!context.is_quiet) std::printf("the archive answers\n");
  });
}

void addFind(CLI::App& pacs_verb, Context& context) {
  auto* verb = pacs_verb.add_subcommand("find", "series in the archive (C-FIND)");
  const auto request = std::make_shared<PacsRequest>();
  addNode(verb, request);
  verb->add_option("--patient-id", request->query.patient_id, "* and ? are wildcards");
  verb->add_option("--patient-name", request->query.patient_name, "as the archive writes it, FAMILY^GIVEN");
  verb->add_option("--date", request->query.study_date, "YYYYMMDD or YYYYMMDD-YYYYMMDD");
  verb->add_option("--study", request->query.study_uid, "study UID");
  verb->add_option("--modality", request->query.modality, "MR, CT, or empty for all")->capture_default_str();
  verb->add_flag("--patients", request->shows_patients, "show patient id and name");
  verb->add_flag("--json", request->is_json, "as JSON");
  verb->callback([&context, request] {
    const auto found = pacs::findSeries(request->connection(), request->query, context.monitor);
    auto json = nlohmann::ordered_json::array();
    for (const auto& series : found) {
      if (request->is_json)
        json.push_back(toJson(series, request->shows_patients));
      else
        print(series, request->shows_patients);
    }
    if (request->is_json)
      std::printf("%s\n", json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
    else if (found.empty() && !context.is_quiet)
      std::printf("nothing found\n");
  });
}

void addGet(CLI::App& pacs_verb, Context& context) {
  auto* verb = pacs_verb.add_subcommand("get", "fetch a series into a folder (C-GET or C-MOVE)");
  const auto request = std::make_shared<PacsRequest>();
  addNode(verb, request);
  verb->add_option("--study", request->study_uid, "study UID")->required();
  verb->add_option("--series", request->series_uid, "series UID")->required();
  verb->add_option("--method", request->method, "get, move, or automatic: get, else move")
      ->check(CLI::IsMember({"automatic", "get", "move"}))
      ->capture_default_str();
  verb->add_option("-o,--output", request->folder, "folder, empty or absent")
      ->required()
      ->check(folderToMake());
  verb->callback([&context, request] {
    const auto how = request->method == "get"    ? pacs::Retrieval::get
                     : request->method == "move" ? pacs::Retrieval::move
                                                 : pacs::Retrieval::automatic;
    const auto received = pacs::retrieve(request->connection(), request->study_uid, request->series_uid,
                                         request->folder, how, context.monitor);
    if (!context.is_quiet)
      std::printf("%d images received in %s\n", received.images, request->folder.c_str());
  });
}

void addStore(CLI::App& pacs_verb, Context& context) {
  auto* verb = pacs_verb.add_subcommand("store", "send DICOM files to the archive (C-STORE)");
  const auto request = std::make_shared<PacsRequest>();
  addNode(verb, request);
  verb->add_option("INPUT", request->folder, "a DICOM file, or a folder with all below it")->required();
  verb->callback([&context, request] {
    const int sent = pacs::store(request->connection(), request->folder, context.monitor);
    if (!context.is_quiet) std::printf("%d images sent\n", sent);
  });
}

}  // namespace

void addPacs(CLI::App& app, Context& context) {
  auto* verb = app.add_subcommand("pacs", "the hospital's archive: echo, find, get, store");
  verb->require_subcommand(1);
  addEcho(*verb, context);
  addFind(*verb, context);
  addGet(*verb, context);
  addStore(*verb, context);
}

}  // namespace facenav::app
