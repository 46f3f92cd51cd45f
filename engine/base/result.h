/// Expected failures: a value or a coded reason. Modules return codes; ui turns them into sentences.
#pragma once

#include <concepts>
#include <expected>
#include <string>
#include <type_traits>
#include <utility>

namespace cusp {

/// std::expected that a caller cannot ignore by mistake.
/// A call whose result does not matter is written static_cast<void>(call()), with the reason beside it.
template <class T, class E>
class [[nodiscard]] Result : public std::expected<T, E> {
  using Base = std::expected<T, E>;

 public:
  Result() = default;  // a value-initialised T
  // Another Result is no value: without the second condition Result<bool> would take its has_value().
  template <class U = T>
    requires(!std::is_void_v<T> && !std::derived_from<std::remove_cvref_t<U>, Base> && std::is_convertible_v<U, T>)
  Result(U&& value) : Base(std::in_place, std::forward<U>(value)) {}
  template <class G>
    requires std::is_constructible_v<E, G>
  Result(std::unexpected<G> failure) : Base(std::unexpect, std::move(failure).error()) {}
};

/// A failure of one module. `code`: the module's enum. `where`: the file, key or device, never a sentence.
/// `detail`: what a library reported, for the log and --verbose.
template <class Code>
struct Failure {
  Code code;
  std::string where;
  std::string detail{};
};

template <class Code>
[[nodiscard]] std::unexpected<Failure<Code>> fail(Code code, std::string where, std::string detail = {}) {
  return std::unexpected(Failure<Code>{code, std::move(where), std::move(detail)});
}

}  // namespace cusp
