#include <sys/resource.h>
#include <unistd.h>

#include "ui/view/low_priority.h"

namespace cusp::ui {
namespace {

// A thread of 8 gets a sixth of the time of one of 0. The mirror and the loop then keep up on two cores.
constexpr int kNice = 8;

}  // namespace

void lower_own_priority() noexcept { setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), kNice); }

}  // namespace cusp::ui
