#pragma once
// One association with the archive as service class user (SCU), plain or over TLS. DCMTK's conditions become
// Errors that name host, port and what to do.

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmnet/scu.h>
#include <dcmtk/dcmtls/tlsscu.h>

#include <memory>
#include <string>

#include "facenav/pacs/pacs.h"

namespace facenav::pacs {

/// Content of a presentation context: one service, its transfer syntaxes, our role.
struct Offer {
  std::string service;  // SOP class UID
  std::vector<std::string> syntaxes;
  bool is_provider = false;  // we act as the storage provider (C-GET)
};

/// Name for messages: "archive.hospital:104 (PACS)".
std::string nameOf(const PacsNode& node);
/// Throws Error: invalid title or port, certificate missing.
void check(const PacsNode& node);
/// Switches off DCMTK's own log, once.
void prepareDcmtk();

void setUp(DcmSCU& scu, const PacsNode& node, const std::vector<Offer>& offers);
void setUpTls(DcmTLSSCU& scu, const Tls& tls);
/// Connects and negotiates. Throws Error.
void connect(DcmSCU& scu, const PacsNode& node);
/// Throws Error if a condition is a failure; `doing` names the operation.
void require(const OFCondition& condition, const PacsNode& node, const std::string& doing);
/// Throws Error if a DIMSE status is a failure.
void requireStatus(unsigned status, const PacsNode& node, const std::string& doing);

/// Connects a `Derived<DcmSCU>` or `Derived<DcmTLSSCU>`, calls `use` with it, and releases it afterwards.
template <template <class> class Derived, class Use, class... Arguments>
auto withAssociation(const PacsNode& node, const std::vector<Offer>& offers, Use use,
                     Arguments&&... arguments) {
  check(node);
  prepareDcmtk();
  const auto run = [&](auto& scu) {
    setUp(scu, node, offers);
    connect(scu, node);
    struct Release {
      DcmSCU& scu;
      ~Release() {
        if (scu.isConnected()) scu.releaseAssociation();
      }
    } release{scu};
    return use(scu);
  };
  if (!node.tls) {
    Derived<DcmSCU> scu(arguments...);
    return run(scu);
  }
  Derived<DcmTLSSCU> scu(arguments...);
  setUpTls(scu, *node.tls);
  return run(scu);
}

template <class Base>
class PlainScu : public Base {};

}  // namespace facenav::pacs
