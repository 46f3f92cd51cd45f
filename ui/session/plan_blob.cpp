#include "ui/session/plan_blob.h"

#include <bit>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace cusp::ui {
namespace {

// Numbers as this machine has them: the bytes stay on it, for the build that wrote them.
static_assert(std::endian::native == std::endian::little);

/// A place, and whether the way to it cuts. The first has the start and the bur's number there, the second the bur's axis.
struct KeptStroke {
  Vec3 to_mm;
  std::uint64_t cut_or_bur;
};
static_assert(sizeof(KeptStroke) == 32 && std::is_trivially_copyable_v<KeptStroke>);

}  // namespace

std::vector<std::byte> plan_bytes(const Plan& plan) {
  std::vector<KeptStroke> kept{{plan.start_mm, plan.bur}, {plan.axis, 0u}};
  for (const Stroke& stroke : plan.strokes) kept.push_back({stroke.to_mm, stroke.cut ? 1u : 0u});
  const auto bytes = std::as_bytes(std::span(kept));
  return {bytes.begin(), bytes.end()};
}

std::optional<Plan> plan_from_bytes(std::span<const std::byte> bytes, std::size_t burs) {
  if (bytes.size() < 3 * sizeof(KeptStroke) || bytes.size() % sizeof(KeptStroke) != 0) return std::nullopt;
  std::vector<KeptStroke> kept(bytes.size() / sizeof(KeptStroke));
  std::memcpy(kept.data(), bytes.data(), bytes.size());
  if (kept[0].cut_or_bur >= burs) return std::nullopt;
  Plan out;
  out.start_mm = kept[0].to_mm;
  out.bur = static_cast<std::uint16_t>(kept[0].cut_or_bur);
  out.axis = kept[1].to_mm;
  for (std::size_t i = 2; i < kept.size(); ++i) out.strokes.push_back({kept[i].to_mm, kept[i].cut_or_bur == 1});
  return out;
}

}  // namespace cusp::ui
