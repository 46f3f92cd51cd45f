/// Ids: UUIDv7 (RFC 9562), sortable by creation time. Each kind has its own type, so that kinds never mix.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace cusp {

struct Uuid {
  std::array<std::uint8_t, 16> bytes{};  // big-endian, as printed
  /// New id from the system clock (ms) and std::random_device. Not for the haptic thread.
  static Uuid v7();
  /// Parses the 36-character form; nullopt for anything else.
  static std::optional<Uuid> parse(std::string_view text) noexcept;
  std::string text() const;  // lower case, 8-4-4-4-12
  bool is_nil() const noexcept { return *this == Uuid{}; }
  friend auto operator<=>(const Uuid&, const Uuid&) = default;
};

/// An id of one kind: Id<struct UserTag> does not convert to Id<struct SessionTag>.
template <class Tag>
struct Id {
  Uuid uuid{};
  static Id make() { return Id{Uuid::v7()}; }
  static std::optional<Id> parse(std::string_view text) noexcept {
    if (auto u = Uuid::parse(text)) return Id{*u};
    return std::nullopt;
  }
  std::string text() const { return uuid.text(); }
  bool is_nil() const noexcept { return uuid.is_nil(); }
  friend auto operator<=>(const Id&, const Id&) = default;
};

using UserId = Id<struct UserTag>;
using CohortId = Id<struct CohortTag>;
using ScenarioId = Id<struct ScenarioTag>;
using VersionId = Id<struct VersionTag>;
using AssignmentId = Id<struct AssignmentTag>;
using SessionId = Id<struct SessionTag>;

}  // namespace cusp
