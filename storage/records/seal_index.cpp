#include "storage/records/seal_index.h"

#include <algorithm>
#include <cstdlib>
#include <sstream>

namespace cusp::storage {
namespace {

std::string last_field_of(const std::string& detail) { return detail.substr(detail.rfind(' ') + 1); }

}  // namespace

void SealIndex::add(const AuditEntry& e) {
  sequence_fell = sequence_fell || (sequence && e.sequence <= *sequence);
  sequence = e.sequence;
  if (e.action == "sealing_began" && !began_utc_us) {
    began_utc_us = e.at_utc_us;
    sealed_later = std::strtoull(e.detail.c_str(), nullptr, 10);
  }
  if (e.action == "account_created") accounts_created.insert(e.subject);
  if (e.action == "statement_erased") statements_erased.insert(e.subject);
  if (e.action == "station_key_added") keys[e.detail].push_back(e.at_utc_us);
  if (e.action == "key_trusted" || e.action == "key_kept") keys[e.detail.substr(0, e.detail.find(' '))].push_back(e.at_utc_us);
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
  add_account(e);
  // The details of older entries end in something else than a seal.
  if (!began_utc_us) return;
  if (e.action == "session_sealed") add_session(e);
  add_row(e);
}

/// Each action may change certain fields only. If another field differs from the seal before, somebody changed it in
/// between: it stays a finding although the program has sealed it since.
void SealIndex::add_account(const AuditEntry& e) {
  struct AccountAction {
    std::string_view action;
    std::array<bool, 6> may_change;  // by kAccountSealFields
  };
  constexpr std::array<AccountAction, 9> actions = {{
      {"account_created", {true, true, true, true, true, true}},
      {"person_sealed", {true, true, true, true, true, true}},
      {"account_renamed", {false, false, false, false, false, true}},
      {"role_changed", {true, false, false, false, true, true}},
      {"account_disabled", {false, true, false, false, false, false}},
      {"account_enabled", {false, true, false, false, false, false}},
      {"password_changed", {false, false, false, true, false, true}},
      {"pin_changed", {false, false, false, false, true, true}},
      {"person_erased", {false, true, false, true, true, true}},
  }};
  const auto action = std::ranges::find(actions, std::string_view(e.action), &AccountAction::action);
  if (action == actions.end()) return;
  auto seal = account_seal_from(e.detail);
  if (!seal) return;
  if (const auto before = accounts.find(e.subject); before != accounts.end()) {
    const AccountSeal& old = before->second.seal;
    const bool new_salt = old[3] != (*seal)[3] || old[4] != (*seal)[4];
    for (std::size_t i = 0; i < seal->size(); ++i) {
      if (old[i] == (*seal)[i] || action->may_change[i] || (i == 5 && new_salt)) continue;
      incidents.push_back(
          {FindingCode::row_changed, "people", e.number, -1, e.subject, std::string(kAccountSealFields[i]), e.at_utc_us});
    }
  }
  accounts[e.subject] = {std::move(*seal), e.at_utc_us};
}

void SealIndex::add_session(const AuditEntry& e) {
  std::istringstream in(e.detail);
  std::string event, link;
  SessionSeal seal{{}, e.at_utc_us};
  in >> event >> seal.head.links >> link;
  if (const auto hash = hash_from_hex(link)) {
    seal.head.link = *hash;
    sessions[e.subject].push_back(seal);
  }
}

void SealIndex::add_row(const AuditEntry& e) {
  if (e.action == "trace_returned") rows[static_cast<std::size_t>(SealedTable::thinned_traces)].erase(e.subject);
  const auto hash = hash_from_hex(last_field_of(e.detail));
  if (!hash) return;
  if (e.action == "commented" || e.action == "comment_sealed") {
    LastSeal<int>& last = comments[{e.subject, *hash}];
    last = {last.seal + 1, e.at_utc_us};
  }
  if (e.action == "comment_erased") {
    if (const auto before = hash_from_hex(e.detail.substr(0, e.detail.find(' ')))) {
      if (const auto old = comments.find({e.subject, *before}); old != comments.end() && old->second.seal > 0) --old->second.seal;
    }
    LastSeal<int>& last = comments[{e.subject, *hash}];
    last = {last.seal + 1, e.at_utc_us};
  }
  const auto keep = [&](SealedTable table, std::initializer_list<std::string_view> actions) {
    if (std::ranges::find(actions, std::string_view(e.action)) == actions.end()) return;
    rows[static_cast<std::size_t>(table)][e.subject] = {*hash, e.at_utc_us};
  };
  keep(SealedTable::cohorts, {"cohort_created", "cohort_sealed"});
  keep(SealedTable::assignments, {"assigned", "assignment_sealed"});
  keep(SealedTable::scenario_versions, {"version_published", "version_kept", "version_sealed"});
  keep(SealedTable::statements, {"stated", "statement_sealed"});
  keep(SealedTable::assessments, {"assessment_set", "assessment_sealed"});
  keep(SealedTable::version_withdrawals, {"version_withdrawn", "withdrawal_sealed"});
  keep(SealedTable::assignment_withdrawals, {"assignment_withdrawn", "assignment_withdrawal_sealed"});
  keep(SealedTable::adjustments, {"adjusted", "adjustment_sealed"});
  keep(SealedTable::other_keys, {"key_trusted", "key_kept", "key_role_changed", "key_revoked", "other_key_sealed"});
  keep(SealedTable::referred, {"referred", "arrived", "referred_sealed"});
  keep(SealedTable::thinned_traces, {"trace_thinned", "thinning_sealed"});
}

}  // namespace cusp::storage
