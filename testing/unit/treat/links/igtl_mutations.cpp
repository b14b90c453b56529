// Reads damaged OpenIGTLink messages under the address and undefined-behaviour sanitizers:
//   igtl_mutations [COUNT] [SEED]

#include "support/igtl_mutations.h"

#include <cstdio>
#include <cstdlib>

int main(int argc, char** argv) {
  const int count = argc > 1 ? std::atoi(argv[1]) : 1000000;
  const unsigned seed = argc > 2 ? unsigned(std::atoi(argv[2])) : 1;
  const auto found = facenav::testing::readMutations(count, seed);
  std::printf("%d damaged messages: %d read, %d with good content, at most %zu bytes held\n", count,
              found.messages, found.contents, found.most_held);
}
