#include "storage/chain_check.h"

#include <algorithm>
#include <utility>

namespace cusp::storage {

Signature signature_of(std::span<const std::byte> bytes) {
  Signature out{};
  if (bytes.size() == out.size()) {
    std::ranges::transform(bytes, out.begin(), [](std::byte b) { return std::to_integer<std::uint8_t>(b); });
  }
  return out;
}

bool ChainFollower::follows(const StoredLink& entry) {
  const Hash256 a = chain_link(stored_, owner_, entry.link);
  const Hash256 b = chain_link(reckoned_, owner_, entry.link);
  const bool good = entry.hash == a || entry.hash == b;
  reckoned_ = good ? entry.hash : a;
  stored_ = entry.hash;
  return good;
}

void check_head(Database& db, const Uuid& owner, const StoredHead& head, const char* table,
                std::vector<ChainFinding>& findings) {
  const auto key = db.first(
      "SELECT public_key FROM station_keys WHERE id = ?1", [](Row row) { return row.hash(0); }, head.key);
  if (!key) return findings.push_back({FindingCode::unreadable, "station_keys"});
  if (!*key || key_id(**key) != head.key) {
    // Was the head's name of the key changed, or the key? Another key under which the signature holds tells.
    const auto keys = db.all("SELECT id, public_key FROM station_keys", [](Row row) {
      return std::pair{row.hash(0), row.hash(1)};
    });
    bool head_is_wrong = false;
    if (keys) {
      for (const auto& [id, other] : *keys) {
        head_is_wrong = head_is_wrong || (key_id(other) == id &&
                                          head_signature_holds(other, owner, head.links, head.link, head.signature));
      }
    }
    return findings.push_back(head_is_wrong ? ChainFinding{FindingCode::head_broken, table}
                                            : ChainFinding{FindingCode::key_changed, "station_keys"});
  }
  if (!head_signature_holds(**key, owner, head.links, head.link, head.signature)) {
    findings.push_back({FindingCode::head_broken, table});
  }
}

}  // namespace cusp::storage
