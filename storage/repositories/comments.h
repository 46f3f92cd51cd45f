/// An instructor's comments on a session, at one moment or on the whole. Free text may hold names, so that comments stay
/// outside the hash chain.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "storage/records/context.h"
#include "storage/base/rights.h"

namespace cusp::storage {

struct Comment {
  Uuid id;
  SessionId session;
  UserId author;
  std::int64_t at_utc_us = 0;
  std::optional<std::uint64_t> tick;  // moment in the session
  std::string text;
};

class Comments {
 public:
  explicit Comments(StorageContext& context) : c_{context} {}
  /// Needs comment. bad_value for an empty text.
  Stored<Comment> add(const Actor& actor, SessionId session, std::optional<std::uint64_t> tick,
                      const std::string& text);
  Stored<std::vector<Comment>> of(SessionId session);  // oldest first

 private:
  StorageContext& c_;
};

}  // namespace cusp::storage
