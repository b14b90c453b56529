// Reads damaged streams of a Socket.IO relay under the address and undefined-behaviour sanitizers:
//   relay_mutations [COUNT] [SEED]

#include "support/relay_mutations.h"

#include <cstdio>
#include <cstdlib>

int main(int argc, char** argv) {
  const int count = argc > 1 ? std::atoi(argv[1]) : 1000000;
  const unsigned seed = argc > 2 ? unsigned(std::atoi(argv[2])) : 1;
  const auto found = facenav::testing::readRelayMutations(count, seed);
  std::printf("%d damaged streams: %d messages, %d events, %d lines, at most %zu bytes held\n", count,
              found.messages, found.events, found.lines, found.most_held);
}
