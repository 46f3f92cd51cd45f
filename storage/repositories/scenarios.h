/// Scenarios, their immutable versions, and drafts. JSON comes and goes as text in canonical form (scenarios/format
/// writes and hashes it); this table keeps exactly those bytes.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scenarios/format/scenario.h"
#include "storage/context.h"
#include "storage/modules.h"
#include "storage/rights.h"

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

/// What came of a change to a draft that was to rest on what its writer had read.
enum class DraftSave : std::uint8_t {
  kept,
  changed_elsewhere,  // the records hold another draft than was read, or none any more: nothing was written
};

class Scenarios {
 public:
  explicit Scenarios(StorageContext& context) : c_{context} {}

  /// A scenario from the library or a file, about to be played: the version with this content, published at need
  /// without an author. Its number is scenario.version, or the next free one where that is taken.
  Stored<ScenarioVersion> ensure(const Scenario& scenario, const std::string& json, const Hash256& content_hash,
                                 const std::map<std::string, Hash256>& files = {});
  /// Needs edit_scenarios. Publishes what an instructor made as the next version (duplicate when the newest one has the
  /// same content), and drops the author's draft of it where that is still `draft`.
  Stored<ScenarioVersion> publish(const Actor& actor, const Scenario& scenario, const std::string& json,
                                  const Hash256& content_hash, const std::map<std::string, Hash256>& files = {},
                                  const std::optional<std::string>& draft = {});

  Stored<ScenarioVersion> version(VersionId id);                       // not_found
  Stored<std::vector<ScenarioVersion>> versions(ScenarioId scenario);  // oldest first
  /// The newest version of every scenario, oldest scenario first.
  Stored<std::vector<ScenarioVersion>> library();

  /// Need edit_scenarios. One draft per scenario and author, which two windows may have open.
  /// `before`: the JSON that the writer has read or written last; nullopt: there was none. One transaction reads and writes.
  Stored<DraftSave> save_draft(const Actor& actor, ScenarioId scenario, const std::string& json,
                               const std::optional<std::string>& before);
  Stored<std::optional<ScenarioDraft>> draft(const Actor& actor, ScenarioId scenario);
  Stored<std::vector<ScenarioDraft>> drafts(const Actor& actor);  // the actor's, newest first
  /// `before` as in save_draft. A draft that is gone already is as good as dropped.
  Stored<DraftSave> drop_draft(const Actor& actor, ScenarioId scenario, const std::string& before);

 private:
  Stored<ScenarioVersion> insert(UserId author, const Scenario& scenario, const std::string& json,
                                 const Hash256& content_hash, const std::map<std::string, Hash256>& files,
                                 const std::optional<std::string>& draft);
  StorageContext& c_;
};

}  // namespace cusp::storage
