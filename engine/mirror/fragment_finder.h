/// Finds the fragments that cutting has severed and sends their names to the loop. The loop's next inputs carry the
/// names. They are recorded, so a replay removes the same fragments in the same ticks. Thread: the mirror's while an
/// exercise runs; the loop's own, between ticks, in virtual time.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/mirror/mirror.h"

namespace cusp::engine {

class FragmentFinder final : public MirrorObserver {
 public:
  /// `hand_over` outlives this. One thread: the one that on_state() or search() is called on.
  explicit FragmentFinder(HandOver& hand_over) : hand_over_(hand_over) {}

  /// Searches every kEveryUs of session time, in the bricks that have changed since.
  void on_state(const StepState& state, const StateNews& news) override;
  /// Without a mirror: finds the changed bricks itself and searches at once.
  void search(const StepState& state);

  /// Of session time. A name takes two inputs and a brick one tick, so a small fragment is removed within 60 ms.
  static constexpr std::uint64_t kEveryUs = 20'000;

 private:
  void name(const Volume& volume);

  HandOver& hand_over_;
  std::vector<std::int32_t> changed_;         // bricks, since the last search whose names all found room
  std::vector<std::uint32_t> seen_revision_;  // [brick], for search()
  std::uint64_t next_us_ = 0;
};

}  // namespace cusp::engine
