#include "engine/loop/realtime.h"

#include <algorithm>

namespace cusp::engine {

RealtimeGrant ask_by(RealtimeWays& ways) noexcept {
  RealtimeGrant grant;
  grant.refusal = RealtimeRefusal::none;
  // A privileged user may take more than the limit.
  int priority = kFifoPriority;
  bool taken = ways.take_fifo(priority);
  if (!taken) {
    priority = std::min(kFifoPriority, ways.own_limit());
    taken = priority > 0 && ways.take_fifo(priority);
  }
  if (taken) {
    grant.level = RealtimeLevel::fifo;
    grant.priority = priority;
  } else {
    priority = kServicePriority;
    switch (ways.ask_service(priority)) {
      case RealtimeWays::Service::granted:
        grant.level = RealtimeLevel::rtkit;
        grant.priority = priority;
        break;
      case RealtimeWays::Service::refused: grant.refusal = RealtimeRefusal::not_permitted; break;
      case RealtimeWays::Service::absent: grant.refusal = RealtimeRefusal::no_service; break;
    }
  }
  if (grant.realtime()) {
    grant.memory_locked = ways.lock_memory();
  } else {
    ways.tighten_timer();
  }
  return grant;
}

}  // namespace cusp::engine
