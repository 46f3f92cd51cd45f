/// Scenarios, their immutable versions, and drafts. scenarios/format writes and hashes canonical JSON; these tables store
/// exactly those bytes.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scenarios/format/scenario.h"
#include "storage/records/context.h"
#include "storage/modules.h"
#include "storage/base/rights.h"

namespace cusp::storage {

/// A published version. Never changes.
struct ScenarioVersion {
  VersionId id;
  ScenarioId scenario;
  int number = 1;   // rises by one with each version of the scenario
  std::string key;  // built-in id, else empty
  LocalText title;
  std::string json;                      // canonical
  Hash256 content_hash{};                // of the whole scenario with its files
  std::map<std::string, Hash256> files;  // file name to blob (Blobs::get)
  UserId author;                         // nil for built-in ones
  std::int64_t published_utc_us = 0;
};

struct ScenarioDraft {
  ScenarioId scenario;
  UserId author;
  std::string json;
  std::int64_t saved_utc_us = 0;
};

/// Result of a change to a draft, based on the text that the caller read before.
enum class DraftSave : std::uint8_t {
  kept,
  changed_elsewhere,  // the table holds another draft than the caller read, or none: nothing was written
};

class Scenarios {
 public:
  explicit Scenarios(StorageContext& context) : c_{context} {}

  /// The version with this content; published without an author if it does not exist yet. Its number is
  /// scenario.version, or the next free one; its id follows from scenario and content.
  Stored<ScenarioVersion> ensure(const Scenario& scenario, const std::string& json_text, const Hash256& content_hash,
                                 const std::map<std::string, Hash256>& files = {});
  /// Needs edit_scenarios. Publishes the next version; duplicate if the newest one has the same content. Deletes the
  /// author's draft if it still equals `draft`.
  Stored<ScenarioVersion> publish(const Actor& actor, const Scenario& scenario, const std::string& json_text,
                                  const Hash256& content_hash, const std::map<std::string, Hash256>& files = {},
                                  const std::optional<std::string>& draft = {});

  Stored<ScenarioVersion> version(VersionId id);                       // not_found
  Stored<std::vector<ScenarioVersion>> versions(ScenarioId scenario);  // oldest first
  /// The newest version of every scenario that is not withdrawn, oldest scenario first.
  Stored<std::vector<ScenarioVersion>> library();
  /// Needs edit_scenarios. Takes the version out of library(), for good: the version before it is then the newest. Records
  /// and assignments of it stay. duplicate if it is withdrawn.
  Stored<void> withdraw(const Actor& actor, VersionId version);
  Stored<bool> withdrawn(VersionId version);

  /// These need edit_scenarios. One draft per scenario and author; two windows may have it open.
  /// `before`: the JSON that the caller read or wrote last; nullopt: none. Compares and writes in one transaction.
  Stored<DraftSave> save_draft(const Actor& actor, ScenarioId scenario, const std::string& json_text,
                               const std::optional<std::string>& before);
  Stored<std::optional<ScenarioDraft>> draft(const Actor& actor, ScenarioId scenario);
  Stored<std::vector<ScenarioDraft>> drafts(const Actor& actor);  // the actor's, newest first
  /// Whether anybody has one. Needs no right: it names nobody.
  Stored<bool> has_draft(ScenarioId scenario);
  /// `before` as in save_draft. kept if no draft exists.
  Stored<DraftSave> drop_draft(const Actor& actor, ScenarioId scenario, const std::string& before);

 private:
  Stored<ScenarioVersion> insert(UserId author, const Scenario& scenario, const std::string& json_text,
                                 const Hash256& content_hash, const std::map<std::string, Hash256>& files,
                                 const std::optional<std::string>& draft);
  StorageContext& c_;
};

}  // namespace cusp::storage
