#include "storage/base/password.h"

#include <algorithm>

#include "storage/base/sodium.h"

namespace cusp::storage {

bool acceptable_password(std::string_view password) noexcept { return password.size() >= 8 && password.size() <= 1024; }

bool acceptable_pin(std::string_view pin) noexcept {
  return pin.size() == 6 && std::ranges::all_of(pin, [](char c) { return c >= '0' && c <= '9'; });
}

std::string hash_password(std::string_view password, const PasswordCost& cost) {
  ready_sodium();
  char out[crypto_pwhash_argon2id_STRBYTES] = {};
  if (crypto_pwhash_argon2id_str(out, password.data(), password.size(), cost.passes, cost.memory_bytes) != 0) return {};
  return out;
}

bool password_matches(const std::string& stored, std::string_view given) noexcept {
  ready_sodium();
  if (stored.empty() || stored.size() >= crypto_pwhash_argon2id_STRBYTES) return false;
  char padded[crypto_pwhash_argon2id_STRBYTES] = {};
  std::ranges::copy(stored, padded);
  return crypto_pwhash_argon2id_str_verify(padded, given.data(), given.size()) == 0;
}

}  // namespace cusp::storage
