/// Reading a JSON document value by value, with a place for every failure. Inside of the reader: only scenarios/format's
/// read*.cpp include this.
#pragma once

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>

#include <nlohmann/json.hpp>

#include "scenarios/format/format_error.h"
#include "scenarios/format/json_text.h"
#include "scenarios/format/ranges.h"
#include "scenarios/format/scenario.h"

namespace cusp::scenarios::format_reader {

using nlohmann::json;

/// Range of a number. Bounds here and in scenario.schema.json are the same; a test holds them together.
struct Range {
  double least, most;
  bool above_least = false;  // least itself is out
  std::string text() const {
    std::string out = above_least ? "(" : "[";
    json_text::append_number(out, least);
    out += ", ";
    json_text::append_number(out, most);
    return out + "]";
  }
  bool holds(double v) const noexcept { return v <= most && (above_least ? v > least : v >= least); }
};

constexpr Range kCoordinate{-1000, 1000};

/// Keeps the first failure; everything after it reads defaults and is thrown away.
class Problems {
 public:
  void add(FormatError code, std::string where, std::string detail = {}) {
    if (!first_) first_ = FormatFailure{code, std::move(where), std::move(detail)};
  }
  const std::optional<FormatFailure>& first() const noexcept { return first_; }

 private:
  std::optional<FormatFailure> first_;
};

class Value;

/// An object being read: each key is asked for once; what was not asked for is unknown.
class Object {
 public:
  Object(const json& node, std::string where, Problems& problems)
      : node_(node), where_(std::move(where)), problems_(problems) {
    if (!node.is_object()) problems_.add(FormatError::wrong_type, where_, "object");
  }
  Object(const Object&) = delete;
  Object& operator=(const Object&) = delete;

  Value need(const char* key);
  /// Calls read(value) when the key is there.
  template <class Read>
  void maybe(const char* key, Read read);
  bool has(const char* key) const { return node_.is_object() && node_.contains(key); }
  void nothing_else() {
    if (!node_.is_object()) return;
    for (auto it = node_.begin(); it != node_.end(); ++it) {
      if (!asked_.contains(it.key()))
        problems_.add(FormatError::unknown_key, where_ + json_text::pointer_step(it.key()));
    }
  }
  const std::string& where() const noexcept { return where_; }

 private:
  const json& node_;
  std::string where_;
  Problems& problems_;
  std::set<std::string> asked_;
};

class Value {
 public:
  Value(const json& node, std::string where, Problems& problems)
      : node_(node), where_(std::move(where)), problems_(problems) {}

  double number(const Range& range) const {
    if (!node_.is_number()) return wrong<double>("number");
    const double v = node_.get<double>();
    if (!range.holds(v)) problems_.add(FormatError::out_of_range, where_, quoted(range));
    return v;
  }
  int integer(const Range& range) const {
    if (!node_.is_number_integer()) return wrong<int>("integer");
    const double v = node_.get<double>();
    if (!range.holds(v)) {
      problems_.add(FormatError::out_of_range, where_, quoted(range));
      return 0;
    }
    return node_.get<int>();
  }
  std::uint64_t seed() const {
    if (!node_.is_number_integer()) return wrong<std::uint64_t>("integer");
    const Range range{0, 9007199254740991.0};  // 2^53 - 1: every JSON reader keeps it
    if (!range.holds(node_.get<double>())) {
      problems_.add(FormatError::out_of_range, where_, range.text());
      return 0;
    }
    return node_.get<std::uint64_t>();
  }
  bool yes() const {
    if (!node_.is_boolean()) return wrong<bool>("boolean");
    return node_.get<bool>();
  }
  std::string text(std::size_t least, std::size_t most) const {
    if (!node_.is_string()) return wrong<std::string>("string");
    const std::string& v = node_.get_ref<const std::string&>();
    // Characters, as the schema counts them: every byte that does not continue one.
    const auto length = static_cast<std::size_t>(
        std::ranges::count_if(v, [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
    if (length < least || length > most) {
      problems_.add(FormatError::out_of_range, where_,
                    Range{static_cast<double>(least), static_cast<double>(most)}.text());
    }
    return v;
  }
  /// A key that `lookup` knows; refused with `code` otherwise.
  template <class Lookup>
  auto key(FormatError code, Lookup lookup) const {
    using T = typename std::invoke_result_t<Lookup, std::string_view>::value_type;
    if (!node_.is_string()) return wrong<T>("string");
    const std::string& v = node_.get_ref<const std::string&>();
    if (auto found = lookup(std::string_view(v))) return *found;
    problems_.add(code, where_, v);
    return T{};
  }
  Vec3 point() const {
    if (!node_.is_array() || node_.size() != 3) return wrong<Vec3>("array of 3 numbers", Vec3(0.0));
    Vec3 v(0.0);
    for (int i = 0; i < 3; ++i) v[i] = item(static_cast<std::size_t>(i)).number(kCoordinate);
    return v;
  }
  /// Calls read(item) for each item of a list of least..most.
  template <class Read>
  void list(std::size_t least, std::size_t most, Read read) const {
    if (!node_.is_array()) {
      problems_.add(FormatError::wrong_type, where_, "array");
      return;
    }
    if (node_.size() < least || node_.size() > most) {
      problems_.add(FormatError::out_of_range, where_,
                    Range{static_cast<double>(least), static_cast<double>(most)}.text());
      return;
    }
    for (std::size_t i = 0; i < node_.size(); ++i) read(item(i));
  }
  LocalText texts() const {
    LocalText out;
    if (!node_.is_object()) return wrong<LocalText>("object");
    for (auto it = node_.begin(); it != node_.end(); ++it) {
      const std::string place = where_ + json_text::pointer_step(it.key());
      if (!is_language(it.key())) problems_.add(FormatError::bad_language, place, it.key());
      out[it.key()] = Value(it.value(), place, problems_).text(1, kMostTextCharacters);
    }
    if (!out.contains("en")) problems_.add(FormatError::bad_language, where_, "en");
    return out;
  }

  const std::string& where() const noexcept { return where_; }
  Problems& problems() const noexcept { return problems_; }
  const json& node() const noexcept { return node_; }
  void refuse(FormatError code, std::string detail = {}) const { problems_.add(code, where_, std::move(detail)); }

 private:
  /// The range that validate() holds, which is narrower than the reader's; the reader's where the table has none.
  std::string quoted(const Range& range) const {
    const NumberRange* const held = range_of(where_);
    return held != nullptr ? held->text() : range.text();
  }
  template <class T>
  T wrong(const char* wanted, T nothing = T{}) const {
    problems_.add(FormatError::wrong_type, where_, wanted);
    return nothing;
  }
  Value item(std::size_t i) const { return {node_[i], where_ + "/" + std::to_string(i), problems_}; }
  /// "en", "pt_BR": two or three small letters, a region of two capitals.
  static bool is_language(std::string_view code) noexcept {
    const auto small = [](char c) { return c >= 'a' && c <= 'z'; };
    const auto capital = [](char c) { return c >= 'A' && c <= 'Z'; };
    const std::size_t end = std::min(code.find('_'), code.size());
    const std::string_view language = code.substr(0, end);
    const std::string_view region = code.substr(end);
    if (language.size() < 2 || language.size() > 3 || !std::ranges::all_of(language, small)) return false;
    return region.empty() || (region.size() == 3 && capital(region[1]) && capital(region[2]));
  }

  const json& node_;
  std::string where_;
  Problems& problems_;
};

inline Value Object::need(const char* key) {
  static const json nothing;  // what is read of it is thrown away: its failure comes after this one
  asked_.insert(key);
  const std::string place = where_ + json_text::pointer_step(key);
  if (!has(key)) {
    problems_.add(FormatError::missing_key, place);
    return {nothing, place, problems_};
  }
  return {node_.at(key), place, problems_};
}

template <class Read>
void Object::maybe(const char* key, Read read) {
  asked_.insert(key);
  if (has(key)) read(Value(node_.at(key), where_ + json_text::pointer_step(key), problems_));
}

/// Looks a key up in a list.
template <class Container>
auto one_of(const Container& known) {
  return [&known](std::string_view key) -> std::optional<std::string> {
    return std::ranges::find(known, key) != std::end(known) ? std::optional<std::string>(key) : std::nullopt;
  };
}

}  // namespace cusp::scenarios::format_reader
