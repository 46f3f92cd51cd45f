#include "storage/exchange/signed_text.h"

#include <charconv>

namespace cusp::storage {
namespace {

constexpr std::string_view kKeyLabel = "key ", kSignatureLabel = "\nsignature ";

Hash256 message_of(std::string_view label, std::string_view description) {
  return Blake2b{}.add_text(label).add_text(description).finish();
}

template <std::size_t N>
std::string hex_of(const std::array<std::uint8_t, N>& bytes) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string out;
  for (const std::uint8_t byte : bytes) out += {digits[byte >> 4], digits[byte & 15]};
  return out;
}

template <std::size_t N>
std::optional<std::array<std::uint8_t, N>> bytes_from(std::string_view hex) {
  std::array<std::uint8_t, N> out{};
  if (hex.size() != 2 * N) return std::nullopt;
  for (std::size_t i = 0; i < N; ++i) {
    const char* at = hex.data() + 2 * i;
    if (std::from_chars(at, at + 2, out[i], 16).ptr != at + 2) return std::nullopt;
  }
  return out;
}

struct KeyAndSignature {
  std::array<std::uint8_t, 32> key{};
  Signature signature{};
};

std::string signature_text(const KeyAndSignature& s) {
  return std::string(kKeyLabel) + hex_of(s.key) + std::string(kSignatureLabel) + hex_of(s.signature) + '\n';
}

std::optional<KeyAndSignature> signature_from(std::string_view text) {
  constexpr std::size_t key_at = kKeyLabel.size(), label_at = key_at + 64, signature_at = label_at + kSignatureLabel.size();
  if (text.size() != signature_at + 128 + 1 || !text.starts_with(kKeyLabel) || text.substr(label_at, kSignatureLabel.size()) != kSignatureLabel)
    return std::nullopt;
  const auto key = bytes_from<32>(text.substr(key_at, 64));
  const auto signature = bytes_from<64>(text.substr(signature_at, 128));
  if (!key || !signature) return std::nullopt;
  return KeyAndSignature{*key, *signature};
}

}  // namespace

SignedText sign_text(const StationKey& key, std::string_view label, std::string description) {
  const Signature signature = key.sign(message_of(label, description));
  return {std::move(description), signature_text(KeyAndSignature{key.public_key, signature})};
}

std::optional<CheckedText> check_text(const SignedText& text, std::string_view label) {
  const auto by = signature_from(text.signature);
  if (!by) return std::nullopt;
  return CheckedText{by->key, signature_holds(by->key, message_of(label, text.description), by->signature)};
}

}  // namespace cusp::storage
