#include "engine/loop/running_digest.h"

#include "engine/volume/hash.h"

namespace cusp::engine {

void RunningDigest::add(const StepState& state, const StepOutput& output) noexcept {
  Hash64 hash;
  hash.add(value_);
  for (const Vec3& v : {output.device_mm, output.proxy_mm, output.force_raw_n, output.force_n}) {
    for (int i = 0; i < 3; ++i) hash.add_double(v[i]);
  }
  hash.add_double(output.stiffness_n_per_mm);
  hash.add_double(output.advance_mm);
  hash.add(output.tick);
  hash.add(output.elapsed_us);
  hash.add(static_cast<std::uint64_t>(output.tissue) | std::uint64_t{output.bur} << 8 |
           std::uint64_t{output.contact} << 24 | std::uint64_t{output.cutting} << 25 | std::uint64_t{output.shank} << 26 |
           std::uint64_t{output.faulted} << 27 | std::uint64_t{output.infeasible} << 28 |
           std::uint64_t{output.overflow} << 29 | std::uint64_t{output.deferred} << 30 |
           static_cast<std::uint64_t>(state.fault()) << 32);

  const auto bricks = state.volume().cut_bricks();
  if (!bricks.empty()) {
    if (next_brick_ >= bricks.size()) next_brick_ = 0;
    const std::int32_t brick = bricks[next_brick_++];
    hash.add(static_cast<std::uint64_t>(brick));
    hash.add_u16({state.volume().cut_of(brick), static_cast<std::size_t>(kBrickVoxels)});
  }
  value_ = hash.value();
}

}  // namespace cusp::engine
