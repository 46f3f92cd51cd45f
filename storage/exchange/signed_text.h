/// A short text and the station's signature over it, as packs and exchange files carry them. Any thread.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "storage/records/station_key.h"

namespace cusp::storage {

struct PackFile {
  std::string name;  // of a file, or of a table
  Hash256 hash{};    // of its content
};

/// Two small texts: the description as JSON, and the public key with its signature over that text.
struct SignedText {
  std::string description, signature;
};

struct CheckedText {
  std::array<std::uint8_t, 32> public_key{};
  bool holds = false;
};

/// `label`: what the text is for; a signature serves that purpose alone.
SignedText sign_text(const StationKey& key, std::string_view label, std::string description);
/// nullopt if the signature is none.
std::optional<CheckedText> check_text(const SignedText& text, std::string_view label);

}  // namespace cusp::storage
