/// Expected failures: a value or a coded reason. Rooms return codes and a place; ui turns codes into sentences.
#pragma once

#include <expected>
#include <string>
#include <utility>

namespace cusp {

template <class T, class E>
using Result = std::expected<T, E>;

/// A failure of one room: `code` is the room's small enum, `where` names the file, key or device it met
/// (never a sentence), `detail` is what a library said, for the log and for --verbose.
template <class Code>
struct Failure {
  Code code;
  std::string where;
  std::string detail{};
};

template <class Code>
std::unexpected<Failure<Code>> fail(Code code, std::string where, std::string detail = {}) {
  return std::unexpected(Failure<Code>{code, std::move(where), std::move(detail)});
}

}  // namespace cusp
