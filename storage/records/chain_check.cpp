#include "storage/records/chain_check.h"

#include <string>
#include <utility>

namespace cusp::storage {

bool ChainFollower::follows(const StoredLink& entry) {
  const Hash256 from_stored = chain_link(stored_, owner_, entry.link);
  const Hash256 from_computed = chain_link(computed_, owner_, entry.link);
  const bool good = entry.hash == from_stored || entry.hash == from_computed;
  computed_ = good ? entry.hash : from_stored;
  stored_ = entry.hash;
  return good;
}

void check_head(Database& db, const Uuid& owner, const SignedHead& head, std::string_view table,
                std::vector<ChainFinding>& findings) {
  const bool own = table == "audit_head";
  const auto key = db.first(own ? kSelectOwnKey : "SELECT public_key FROM station_keys WHERE id = ?1",
                            [](Row row) { return row.hash(0); }, head.key);
  if (!key) return findings.push_back({FindingCode::unreadable, "station_keys"});
  if (!*key || key_id(**key) != head.key) {
    // Either the head's key id was changed, or the key. If the signature holds under another key, it was the id.
    const auto keys = db.all("SELECT id, public_key FROM station_keys", [](Row row) {
      return std::pair{row.hash(0), row.hash(1)};
    });
    bool head_is_wrong = false;
    if (keys) {
      for (const auto& [id, other] : *keys) {
        head_is_wrong =
            head_is_wrong || (key_id(other) == id && head_signature_holds(other, owner, head.head, head.signature));
      }
    }
    return findings.push_back(head_is_wrong ? ChainFinding{FindingCode::head_broken, std::string(table)}
                                            : ChainFinding{FindingCode::key_changed, "station_keys"});
  }
  if (!head_signature_holds(**key, owner, head.head, head.signature)) {
    findings.push_back({FindingCode::head_broken, std::string(table)});
  }
}

}  // namespace cusp::storage
