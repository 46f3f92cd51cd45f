/// One mistake at one of three sizes, added to the reference's path. A grade must find it, and nothing else.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "scenarios/modules.h"

namespace cusp::scenarios {

enum class SingleFault : std::uint8_t {
  too_deep,         // pulpal floor below the target's
  too_shallow,      // pulpal floor above it
  too_wide,         // walls of the outline further out
  tilted_wall,      // the wall towards +y opens upwards
  undermined,       // at last a round bur hollows the walls, to its height above the pulpal floor
  rough_floor,      // pits in the floor, 1.3 mm apart
  thin_ridge,       // the outline longer towards the nearest marginal ridge
  exposed_pulp,     // at last down into the pulp's roof
  nicked_neighbour, // the bur touches down on the tooth beside
  contact_closed,   // a shell left towards the tooth beside
  caries_left,      // the lesion's rim left, beside the access
  over_excavated,   // sound tissue taken about the lesion
  wrong_bur,        // a wider bur, its tip on the reference's path
  tremor,           // the path shaken
  dry_cutting       // the path without coolant for a while
};
enum class FaultSize : std::uint8_t { small, medium, large };
inline constexpr std::array<std::string_view, 3> kFaultSizeKeys = {"small", "medium", "large"};

struct SingleFaultRow {
  SingleFault fault;
  std::string_view key;
  std::string_view unit;       // mm, deg or s
  std::array<double, 3> sizes; // by FaultSize
  std::string_view reason;     // of the sizes
};
/// In the order of SingleFault.
[[nodiscard]] std::span<const SingleFaultRow> single_faults() noexcept;

struct SizedFault {
  SingleFault fault;
  FaultSize size;
  double amount() const noexcept;  // in the row's unit
};
/// "too_deep:small", "tremor:large"; nullopt for any other name.
[[nodiscard]] std::optional<SizedFault> sized_fault_by_name(std::string_view name) noexcept;
[[nodiscard]] std::string key_of(SizedFault fault);

}  // namespace cusp::scenarios
