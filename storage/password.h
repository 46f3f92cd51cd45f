/// Passwords and PINs as argon2id strings (libsodium); nothing else about them is ever stored.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace cusp::storage {

/// What one guess costs. Any thread.
struct PasswordCost {
  unsigned long long passes = 2;
  std::size_t memory_bytes = std::size_t{64} << 20;
  /// libsodium's INTERACTIVE: 64 MiB and 2 passes.
  static constexpr PasswordCost interactive() noexcept { return {}; }
  /// The least that libsodium takes: for tests, never for a school.
  static constexpr PasswordCost least() noexcept { return {1, 8192}; }
};

/// At least 8 bytes; at most 1024.
bool acceptable_password(std::string_view password) noexcept;
/// Exactly six ASCII digits.
bool acceptable_pin(std::string_view pin) noexcept;

/// Self-describing string with its own random salt; empty when memory for the cost could not be had.
std::string hash_password(std::string_view password, const PasswordCost& cost);
/// Takes the same time whether or not it matches; false for an empty or damaged `stored`.
bool password_matches(const std::string& stored, std::string_view given) noexcept;

}  // namespace cusp::storage
