#include "scu.h"

namespace facenav::pacs {

void echo(const PacsNode& node) {
  withAssociation<PlainScu>(
      node, {{UID_VerificationSOPClass, {UID_LittleEndianImplicitTransferSyntax}}},
      [&](DcmSCU& scu) { require(scu.sendECHORequest(0), node, "asking for an echo"); });
}

}  // namespace facenav::pacs
