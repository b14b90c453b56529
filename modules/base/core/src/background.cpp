#include "facenav/core/later_answer.h"

#ifdef __linux__
#include <sys/resource.h>
#endif

namespace facenav {
inline namespace core {

void runInBackground() {
#ifdef __linux__
  setpriority(PRIO_PROCESS, 0, 10);  // 0: this thread only
#endif
}

}  // namespace core
}  // namespace facenav
