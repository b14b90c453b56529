#include "scu.h"

#include <dcmtk/dcmdata/dcuid.h>
#include <dcmtk/dcmnet/assoc.h>
#include <dcmtk/dcmnet/cond.h>
#include <dcmtk/dcmtls/tlslayer.h>
#include <dcmtk/oflog/oflog.h>

#include <mutex>

#include "dimse_status.h"
#include "facenav/core/error.h"
#include "facenav/core/number_text.h"

namespace facenav::pacs {
namespace {

namespace fs = std::filesystem;

void checkTitle(const std::string& title, const std::string& whose) {
  bool is_sound = !title.empty() && title.size() <= 16 && title.find_first_not_of(' ') != std::string::npos;
  for (const char c : title) is_sound &= c >= 0x20 && c < 0x7F && c != '\\';
  if (!is_sound)
    throw Error(whose + " application entity title '" + title + "' is impossible", {},
                "1 to 16 plain characters");
}

void checkFile(const fs::path& file) {
  std::error_code error;
  if (!fs::is_regular_file(file, error))
    throw Error("certificate or key is not there", file.string(), "give a PEM file");
}

/// DCMTK's message without its line breaks.
std::string wordsOf(const OFCondition& condition) {
  std::string words = condition.text();
  for (char& c : words)
    if (c == '\n' || c == '\r') c = ' ';
  return words;
}

}  // namespace

std::string nameOf(const PacsNode& node) {
  return node.host + ":" + std::to_string(node.port) + " (" + node.title + ")";
}

void check(const PacsNode& node) {
  if (node.host.empty()) throw Error("no archive host is given", {}, "give its name or address");
  for (const int port : {node.port, node.own_port})
    if (port < 1 || port > 65535)
      throw Error("port " + std::to_string(port) + " is impossible", {}, "1 to 65535");
  if (node.timeout_s < 1 || node.timeout_s > 3600)
    throw Error("timeout is impossible", std::to_string(node.timeout_s) + " s", "1 to 3600");
  checkTitle(node.title, "the archive's");
  checkTitle(node.own_title, "our own");
  if (!node.tls) return;
  checkFile(node.tls->trusted_certificate);
  if (node.tls->certificate.empty() && node.tls->key.empty()) return;
  checkFile(node.tls->certificate);
  checkFile(node.tls->key);
}

void prepareDcmtk() {
  static std::once_flag once;
  std::call_once(once, [] {
    OFLog::configure(OFLogger::OFF_LOG_LEVEL);  // every failure is reported as an Error instead
    dcmConnectionTimeout.set(10);
  });
}

void setUp(DcmSCU& scu, const PacsNode& node, const std::vector<Offer>& offers) {
  scu.setPeerHostName(node.host.c_str());
  scu.setPeerPort(Uint16(node.port));
  scu.setPeerAETitle(node.title.c_str());
  scu.setAETitle(node.own_title.c_str());
  scu.setDIMSEBlockingMode(DIMSE_NONBLOCKING);
  scu.setDIMSETimeout(Uint32(node.timeout_s));
  scu.setACSETimeout(Uint32(node.timeout_s));
  scu.setConnectionTimeout(Sint32(node.timeout_s));
  scu.setProgressNotificationMode(OFFalse);
  scu.setDatasetConversionMode(OFFalse);
  for (const Offer& offer : offers) {
    OFList<OFString> syntaxes;
    for (const auto& syntax : offer.syntaxes) syntaxes.push_back(syntax.c_str());
    scu.addPresentationContext(offer.service.c_str(), syntaxes,
                               offer.is_provider ? ASC_SC_ROLE_SCP : ASC_SC_ROLE_DEFAULT);
  }
}

void setUpTls(DcmTLSSCU& scu, const Tls& tls) {
  scu.addTrustedCertFile(tls.trusted_certificate.c_str());
  scu.setPeerCertVerification(DCV_requireCertificate);
  if (!tls.key.empty()) scu.enableAuthentication(tls.key.c_str(), tls.certificate.c_str());
}

void connect(DcmSCU& scu, const PacsNode& node) {
  require(scu.initNetwork(), node, "setting up the network");
  const OFCondition condition = scu.negotiateAssociation();
  if (condition.good()) return;
  if (condition == NET_EC_NoAcceptablePresentationContexts)
    throw Error("the archive offers none of the services asked for", nameOf(node), "ask its administrator");
  if (condition == DUL_ASSOCIATIONREJECTED)
    throw Error("the archive refuses us (" + wordsOf(condition) + ")", nameOf(node),
                "have '" + node.own_title + "' entered there, and check its title here");
  throw Error("the archive does not answer (" + wordsOf(condition) + ")", nameOf(node),
              "check host, port, firewall and TLS");
}

void require(const OFCondition& condition, const PacsNode& node, const std::string& doing) {
  if (condition.good()) return;
  throw Error("failed while " + doing + " (" + wordsOf(condition) + ")", nameOf(node), "try again");
}

void requireStatus(unsigned status, const PacsNode& node, const std::string& doing) {
  constexpr unsigned kWarningsFrom = 0xB000, kWarningsTo = 0xBFFF, kPending = 0xFF00, kPendingToo = 0xFF01;
  if (status == 0 || status == kPending || status == kPendingToo ||
      (status >= kWarningsFrom && status <= kWarningsTo))
    return;
  const auto [words, remedy] = statusInWords(status, node.own_title);
  throw Error(words + " while " + doing + formatted(" (status 0x%04X)", status), nameOf(node), remedy);
}

}  // namespace facenav::pacs
