#include "storage/exchange/signed_text.h"

#include "storage/base/hex.h"

namespace cusp::storage {
namespace {

constexpr std::string_view kKeyLabel = "key ", kSignatureLabel = "\nsignature ";

Hash256 message_of(std::string_view label, std::string_view description) {
  return Blake2b{}.add_text(label).add_text(description).finish();
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
  KeyAndSignature out;
  if (!bytes_from_hex(text.substr(key_at, 64), out.key) || !bytes_from_hex(text.substr(signature_at, 128), out.signature)) return std::nullopt;
  return out;
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
