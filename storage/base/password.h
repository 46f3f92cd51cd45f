/// Passwords and PINs as argon2id strings (libsodium). Nothing else about a secret is stored.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace cusp::storage {

/// Cost of one guess. Any thread.
struct PasswordCost {
  unsigned long long passes = 2;
  std::size_t memory_bytes = std::size_t{64} << 20;
  /// libsodium's INTERACTIVE: 64 MiB and 2 passes.
  static constexpr PasswordCost interactive() noexcept { return {}; }
  /// The least that libsodium accepts: for tests only.
  static constexpr PasswordCost least() noexcept { return {1, 8192}; }
};

/// At least 8 bytes; at most 1024.
bool acceptable_password(std::string_view password) noexcept;
/// Exactly six ASCII digits.
bool acceptable_pin(std::string_view pin) noexcept;

/// Self-describing string with its own random salt; empty if the system has too little memory for the cost.
std::string hash_password(std::string_view password, const PasswordCost& cost);
/// Takes the same time whether or not the secret matches. False for an empty or damaged `stored`.
bool password_matches(const std::string& stored, std::string_view given) noexcept;

}  // namespace cusp::storage
