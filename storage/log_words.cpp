#include "storage/log_words.h"

#include <algorithm>
#include <cstdlib>
#include <sstream>

namespace cusp::storage {
namespace {

std::string last_word_of(const std::string& detail) { return detail.substr(detail.rfind(' ') + 1); }

}  // namespace

void LogWords::take(const AuditEntry& e) {
  sequence_fell = sequence_fell || (sequence && e.sequence <= *sequence);
  sequence = e.sequence;
  if (e.action == "sealing_began" && !began_utc_us) {
    began_utc_us = e.at_utc_us;
    sealed_later = std::strtoull(e.detail.c_str(), nullptr, 10);
  }
  if (e.action == "account_created") accounts_created.insert(e.subject);
  if (e.action == "station_key_added") keys[e.detail].push_back(e.at_utc_us);
  for (const FindingCode code : {FindingCode::rolled_back, FindingCode::counter_missing, FindingCode::counter_broken,
                                 FindingCode::log_damaged}) {
    if (e.action == key_of(code)) {
      incidents.push_back({code, "audit_log", e.number, -1, {}, e.detail, e.at_utc_us});
    }
  }
  if (e.action == "cohort_joined" || e.action == "cohort_left") {
    if (const auto cohort = Uuid::parse(e.detail)) {
      members[{*cohort, e.subject}] = {e.action == "cohort_joined", e.at_utc_us};
    }
  }
  take_person(e);
  // What stands before the first seal ends in other words than seals.
  if (!began_utc_us) return;
  if (e.action == "session_sealed") take_session(e);
  take_row(e);
}

/// Each action may change its own words only: what else differs from the entry before was changed in between, and stays
/// named although the program has sealed it since.
void LogWords::take_person(const AuditEntry& e) {
  struct PersonAction {
    std::string_view action;
    std::array<bool, 6> may_change;  // kPersonSealWords
  };
  constexpr std::array<PersonAction, 8> actions = {{
      {"account_created", {true, true, true, true, true, true}},
      {"person_sealed", {true, true, true, true, true, true}},
      {"account_renamed", {false, false, false, false, false, true}},
      {"role_changed", {true, false, false, false, true, true}},
      {"account_disabled", {false, true, false, false, false, false}},
      {"account_enabled", {false, true, false, false, false, false}},
      {"password_changed", {false, false, false, true, false, true}},
      {"pin_changed", {false, false, false, false, true, true}},
  }};
  const auto action = std::ranges::find(actions, std::string_view(e.action), &PersonAction::action);
  if (action == actions.end()) return;
  auto seal = person_seal_from(e.detail);
  if (!seal) return;
  if (const auto before = people.find(e.subject); before != people.end()) {
    const PersonSeal& old = before->second.seal;
    const bool new_salt = old[3] != (*seal)[3] || old[4] != (*seal)[4];
    for (std::size_t i = 0; i < seal->size(); ++i) {
      if (old[i] == (*seal)[i] || action->may_change[i] || (i == 5 && new_salt)) continue;
      incidents.push_back(
          {FindingCode::row_changed, "people", e.number, -1, e.subject, std::string(kPersonSealWords[i]), e.at_utc_us});
    }
  }
  people[e.subject] = {std::move(*seal), e.at_utc_us};
}

void LogWords::take_session(const AuditEntry& e) {
  std::istringstream in(e.detail);
  std::string event, link;
  SessionSeal seal{0, {}, e.at_utc_us};
  in >> event >> seal.links >> link;
  if (const auto hash = hash_from_hex(link)) {
    seal.link = *hash;
    sessions[e.subject].push_back(seal);
  }
}

void LogWords::take_row(const AuditEntry& e) {
  const auto hash = hash_from_hex(last_word_of(e.detail));
  if (!hash) return;
  if (e.action == "commented" || e.action == "comment_sealed") {
    LastWord<int>& word = comments[{e.subject, *hash}];
    word = {word.seal + 1, e.at_utc_us};
  }
  const auto keep = [&](SealedTable table, std::initializer_list<std::string_view> actions) {
    if (std::ranges::find(actions, std::string_view(e.action)) == actions.end()) return;
    rows[static_cast<std::size_t>(table)][e.subject] = {*hash, e.at_utc_us};
  };
  keep(SealedTable::cohorts, {"cohort_created", "cohort_sealed"});
  keep(SealedTable::assignments, {"assigned", "assignment_sealed"});
  keep(SealedTable::scenario_versions, {"version_published", "version_kept", "version_sealed"});
}

}  // namespace cusp::storage
