#include "scenarios/tissues/tissue_facts.h"

#include <cassert>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

namespace cusp::scenarios {

namespace embedded {
extern const std::string_view tissues;
}

namespace {

using Json = nlohmann::json;
using Error = TissueTableError;

constexpr std::string_view kUnverified = "M";
constexpr std::size_t kFirstOwnCode = 16;

enum class Least : std::uint8_t { included, excluded };

/// Range of a figure.
struct Range {
  double least, most;
  Least end;

  bool holds(double v) const noexcept { return v <= most && (end == Least::excluded ? v > least : v >= least); }
};

/// Walks the file; keeps the first failure.
class TableReader {
 public:
  explicit TableReader(const Json& document) : document_(document) {}

  Result<TissueTable, Failure<Error>> run() {
    if (!document_.is_object()) return fail(Error::bad_json, std::string());
    if (!document_.contains("sources") || !document_["sources"].is_object()) wrong(Error::missing, "/sources");
    for (const char* key : {"tissues", "own"})
      if (!document_.contains(key)) wrong(Error::missing, std::string("/") + key);
    if (failed_) return std::unexpected(*failed_);
    TissueTable out;
    own(out);
    std::set<std::size_t> seen;
    std::size_t i = 0;
    for (const Json& one : document_["tissues"]) {
      const std::string where = "/tissues/" + std::to_string(i++);
      const auto tissue = one.is_object() && one.contains("tissue") && one["tissue"].is_string()
                              ? tissue_from_key(one["tissue"].get_ref<const std::string&>())
                              : std::nullopt;
      if (!tissue || *tissue == Tissue::empty || !seen.insert(index_of(*tissue)).second) {
        wrong(Error::unknown_tissue, where + "/tissue");
        continue;
      }
      out[index_of(*tissue)] = facts(one, where);
      out[index_of(*tissue)].colour = colour(one, where);
    }
    if (seen.size() + 1 != kTissueKeys.size()) wrong(Error::missing, "/tissues");
    grown(out);
    out[index_of(Tissue::empty)].colour = out[index_of(Tissue::enamel)].colour;
    if (failed_) return std::unexpected(*failed_);
    return out;
  }

 private:
  void wrong(Error code, std::string where) {
    if (!failed_) failed_ = Failure<Error>{code, std::move(where), {}};
  }

  /// The value of a figure, its source noted; null where there is none.
  template <class Value>
  const Json* figure(const Json& owner, const char* key, const std::string& where, Sourced<Value>& out) {
    const std::string at = where + "/" + key;
    if (!owner.is_object() || !owner.contains(key) || !owner[key].is_object() || !owner[key].contains("value")) {
      wrong(Error::missing, at);
      return nullptr;
    }
    const Json& both = owner[key];
    if (!both.contains("source") || !both["source"].is_string() ||
        !document_["sources"].contains(both["source"].get_ref<const std::string&>())) {
      wrong(Error::unknown_source, at + "/source");
      return nullptr;
    }
    out.source = both["source"].get<std::string>();
    out.verified = out.source != kUnverified;
    return &both["value"];
  }

  Sourced<double> number(const Json& owner, const char* key, const std::string& where, const Range& range) {
    Sourced<double> out;
    const Json* value = figure(owner, key, where, out);
    if (value == nullptr) return out;
    if (value->is_number()) out.value = value->get<double>();
    if (!value->is_number() || !range.holds(out.value)) wrong(Error::bad_value, where + "/" + key);
    return out;
  }

  std::optional<std::uint32_t> rgb(const Json& value) {
    if (!value.is_string()) return std::nullopt;
    const std::string& text = value.get_ref<const std::string&>();
    if (text.size() != 7 || text[0] != '#' || text.find_first_not_of("0123456789ABCDEF", 1) != std::string::npos)
      return std::nullopt;
    return static_cast<std::uint32_t>(std::stoul(text.substr(1), nullptr, 16));
  }

  Sourced<std::uint32_t> colour(const Json& owner, const std::string& where) {
    Sourced<std::uint32_t> out;
    const Json* value = figure(owner, "colour", where, out);
    if (value == nullptr) return out;
    if (const auto read = rgb(*value)) {
      out.value = *read;
    } else {
      wrong(Error::bad_value, where + "/colour");
    }
    return out;
  }

  TissueFacts facts(const Json& owner, const std::string& where) {
    TissueFacts out;
    out.stiffness_n_per_mm = number(owner, "stiffness_n_per_mm", where, {0.0, 20.0, Least::excluded});
    out.speed_mm_s = number(owner, "speed_mm_s", where, {0.0, 100.0, Least::included});
    out.tone_hz = number(owner, "tone_hz", where, {0.0, 20000.0, Least::excluded});
    out.loudness = number(owner, "loudness", where, {0.0, 1.0, Least::included});
    if (const Json* value = figure(owner, "critical", where, out.critical)) {
      if (value->is_boolean()) {
        out.critical.value = value->get<bool>();
      } else {
        wrong(Error::bad_value, where + "/critical");
      }
    }
    return out;
  }

  void own(TissueTable& out) {
    const TissueFacts all = facts(document_["own"], "/own");
    Sourced<std::uint32_t> shade;
    const Json* list = figure(document_["own"], "colours", "/own", shade);
    if (list != nullptr && (!list->is_array() || list->empty())) wrong(Error::bad_value, "/own/colours");
    if (failed_) return;
    for (std::size_t t = 1; t < out.size(); ++t) {
      out[t] = all;
      const auto read = rgb((*list)[t % list->size()]);
      if (!read) return wrong(Error::bad_value, "/own/colours");
      shade.value = *read;
      out[t].colour = shade;
    }
  }

  /// Tissues of grown teeth among the codes that volumes name for themselves.
  void grown(TissueTable& out) {
    if (!document_.contains("grown")) return;
    std::size_t i = 0;
    for (const Json& one : document_["grown"]) {
      const std::string where = "/grown/" + std::to_string(i++);
      const bool coded = one.is_object() && one.contains("code") && one["code"].is_number_unsigned();
      const std::size_t code = coded ? one["code"].get<std::size_t>() : 0;
      if (code < kFirstOwnCode || code >= kTissueCodes) {
        wrong(Error::unknown_tissue, where + "/code");
        continue;
      }
      out[code] = facts(one, where);
      out[code].colour = colour(one, where);
    }
  }

  const Json& document_;
  std::optional<Failure<Error>> failed_;
};

}  // namespace

Result<TissueTable, Failure<TissueTableError>> read_tissue_table(std::string_view text) {
  const Json document = Json::parse(text, nullptr, false);
  if (document.is_discarded()) return fail(Error::bad_json, std::string());
  return TableReader(document).run();
}

const TissueFacts& tissue_facts(Tissue tissue) noexcept {
  static const TissueTable table = [] {
    auto read = read_tissue_table(embedded::tissues);
    assert(read && "tests/scenarios/tissues hold that the program's own table reads");
    return read ? std::move(*read) : TissueTable{};
  }();
  return table[index_of(tissue) % kTissueCodes];
}

}  // namespace cusp::scenarios
