#include "scenarios/templates/expression.h"

#include <charconv>
#include <cmath>

namespace cusp::scenarios {

namespace {

class Parser {
 public:
  Parser(std::string_view text, const Scope& scope) : rest_(text), scope_(scope) {}

  Result<double, Failure<ExpressionError>> whole() {
    const double value = sum();
    skip();
    if (!failure_ && !rest_.empty()) refuse(ExpressionError::syntax, rest_);
    if (!failure_ && !std::isfinite(value)) refuse(ExpressionError::not_finite, {});
    if (failure_) return std::unexpected(*failure_);
    return value;
  }

 private:
  static bool in_name(char c) noexcept {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '.';
  }
  void refuse(ExpressionError code, std::string_view where) {
    if (!failure_) failure_ = Failure<ExpressionError>{code, std::string(where), {}};
    rest_ = {};
  }
  void skip() {
    while (!rest_.empty() && rest_.front() == ' ') rest_.remove_prefix(1);
  }
  bool take(char c) {
    skip();
    if (rest_.empty() || rest_.front() != c) return false;
    rest_.remove_prefix(1);
    return true;
  }
  double sum() {
    double value = product();
    while (!failure_) {
      if (take('+')) value += product();
      else if (take('-')) value -= product();
      else break;
    }
    return value;
  }
  double product() {
    double value = factor();
    while (!failure_) {
      if (take('*')) value *= factor();
      else if (take('/')) value /= factor();
      else break;
    }
    return value;
  }
  double factor() {
    if (++depth_ > kMostNested) refuse(ExpressionError::syntax, rest_);
    const double value = failure_ ? 0.0 : take('-') ? -factor() : take('(') ? closed(sum()) : atom();
    --depth_;
    return value;
  }
  double closed(double value) {
    if (!take(')')) refuse(ExpressionError::syntax, rest_);
    return value;
  }
  double atom() {
    skip();
    if (rest_.empty()) {
      refuse(ExpressionError::syntax, {});
      return 0.0;
    }
    if (rest_.front() >= '0' && rest_.front() <= '9') return number();
    std::size_t length = 0;
    while (length < rest_.size() && in_name(rest_[length])) ++length;
    if (length == 0) {
      refuse(ExpressionError::syntax, rest_);
      return 0.0;
    }
    const std::string_view name = rest_.substr(0, length);
    rest_.remove_prefix(length);
    if ((name == "min" || name == "max" || name == "at_least") && take('('))
      return of_two(name == "max" ? Pick::greatest : name == "min" ? Pick::least : Pick::whether_at_least);
    const auto known = scope_.find(name);
    if (known != scope_.end()) return known->second;
    refuse(ExpressionError::unknown_name, name);
    return 0.0;
  }
  enum class Pick : std::uint8_t { least, greatest, whether_at_least };
  double of_two(Pick pick) {
    const double a = sum();
    if (!take(',')) refuse(ExpressionError::syntax, rest_);
    const double b = closed(sum());
    if (pick == Pick::whether_at_least) return a >= b ? 1.0 : 0.0;
    return (a > b) == (pick == Pick::greatest) ? a : b;
  }
  double number() {
    double value = 0.0;
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    if (error != std::errc()) {
      refuse(ExpressionError::not_finite, rest_);
      return 0.0;
    }
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return value;
  }

  std::string_view rest_;
  const Scope& scope_;
  int depth_ = 0;
  std::optional<Failure<ExpressionError>> failure_;
};

}  // namespace

Result<double, Failure<ExpressionError>> evaluate(std::string_view text, const Scope& scope) { return Parser(text, scope).whole(); }

}  // namespace cusp::scenarios
