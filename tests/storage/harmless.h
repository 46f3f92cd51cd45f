/// Changes made by SQL that verify_store() does not find, and why each is harmless or beyond what a file can show.
#pragma once

#include <span>
#include <string_view>

namespace cusp::test {

struct Harmless {
  std::string_view table, kind, column;  // column: "" = every one
  std::string_view reason;
};
std::span<const Harmless> harmless_tamperings() noexcept;

}  // namespace cusp::test
