/// Looks for pieces that cutting has severed, and names them to the loop, whose next inputs carry the names: so they are in
/// the record, and a replay loses the same pieces in the same ticks. On the mirror's thread while an exercise runs; on the
/// loop's own, between its turns, in virtual time, so that the same hand gives the same record.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/mirror/mirror.h"

namespace cusp::engine {

class LooseFinder final : public MirrorObserver {
 public:
  /// `hand_over` outlives this. One thread: the one that on_state() or look() is called on.
  explicit LooseFinder(HandOver& hand_over) : hand_over_(hand_over) {}

  /// Looks every kEveryUs of session time, at what changed since it last looked.
  void on_state(const StepState& state, const StateNews& news) override;
  /// Without a mirror: finds out for itself what changed, and looks at once.
  void look(const StepState& state);

  /// Of session time. With the loop's two inputs for a name and a brick a tick a small piece is gone in 60 ms.
  static constexpr std::uint64_t kEveryUs = 20'000;

 private:
  void name(const Volume& volume);

  HandOver& hand_over_;
  std::vector<std::int32_t> changed_;         // bricks, since it last looked
  std::vector<std::uint32_t> seen_revision_;  // [brick], for look()
  std::uint64_t next_us_ = 0;
};

}  // namespace cusp::engine
