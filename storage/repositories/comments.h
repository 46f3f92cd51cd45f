/// Comments on a session, at one moment, at a place or on the whole: statements, and the table `comments` of older programs.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/vec.h"
#include "storage/records/context.h"

namespace cusp::storage {

struct Comment {
  Uuid id;
  SessionId session;
  UserId author;
  std::int64_t at_utc_us = 0;
  std::optional<std::uint64_t> tick;  // moment in the session
  std::string text;
  std::optional<Vec3> place_mm{};
};

class Comments {
 public:
  explicit Comments(StorageContext& context) : c_{context} {}
  Stored<std::vector<Comment>> of(SessionId session);  // oldest first, without withdrawn ones

 private:
  StorageContext& c_;
};

}  // namespace cusp::storage
