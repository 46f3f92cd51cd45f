#include "tests/storage/harmless.h"

#include <array>

namespace cusp::test {

std::span<const Harmless> harmless_tamperings() noexcept {
  static constexpr std::string_view draft =
      "an author's work in progress: nobody is graded by it, and what is published of it is sealed";
  static constexpr std::string_view unnamed = "no session and no version names this blob: it decides nothing";
  static constexpr std::string_view tries =
      "sets when the next try is admitted, not an identity; the log has each wrong try";
  static constexpr std::string_view open_account =
      "an account without password and PIN proves nobody's identity: anybody signs in as it";
  static constexpr std::array<Harmless, 14> list = {{
      {"scenario_drafts", "change", "", draft},
      {"scenario_drafts", "delete", "", draft},
      {"scenario_drafts", "insert", "", draft},
      {"blobs", "delete unnamed", "", unnamed},
      {"blobs", "insert unnamed", "", unnamed},
      {"people", "change", "wrong_tries", tries},
      {"people", "change", "locked_until", tries},
      {"people", "change open account", "number", open_account},
      {"people", "change open account", "name", open_account},
      {"station", "change", "next_sequence", "raised: a gap in numbers of which only the order counts"},
      {"station", "change", "one", "the key of a table of one row: nothing reads it"},
      {"station_keys", "change", "added_at", "nothing reads it; the key's own entry in the log has the time"},
      {"counter", "older counter", "", "a counter that saw less finds less, and is brought up at the next opening"},
      {"counter", "older file with its counter", "",
       "the state of that day, whole; takes write access beside the key, so keep the key where pupils cannot write"},
  }};
  return list;
}

}  // namespace cusp::test
