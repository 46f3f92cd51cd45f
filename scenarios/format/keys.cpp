#include "scenarios/format/keys.h"

#include <algorithm>
#include <cassert>

namespace cusp::scenarios {
namespace {

constexpr std::string_view kRemoved = "removed_";
constexpr std::array<std::string_view, 16> kOwnKeys = {"16", "17", "18", "19", "20", "21", "22", "23",
                                                       "24", "25", "26", "27", "28", "29", "30", "31"};
constexpr std::size_t kFirstOwn = 16;

}  // namespace

bool is_target_name(std::string_view name) noexcept {
  constexpr std::size_t kMost = 32;
  const auto small = [](char c) { return c >= 'a' && c <= 'z'; };
  const auto allowed = [small](char c) { return small(c) || (c >= '0' && c <= '9') || c == '_'; };
  return !name.empty() && name.size() <= kMost && small(name.front()) && std::ranges::all_of(name, allowed);
}

bool is_of_cavity(std::string_view metric) noexcept {
  constexpr std::array<std::string_view, 10> kNot = {"time",           "force_",   "dry_cutting_time", "temperature_rise_peak", "protected_removed",
                                                     "contact_broken", "clearance_", "caries_left_",     "sound_lost",            "gingival_floor_mesiodistal"};
  return std::ranges::none_of(kNot, [metric](std::string_view key) { return metric.starts_with(key); });
}

std::optional<MetricKey> metric_from_key(std::string_view key) noexcept {
  if (key.find('@') != std::string_view::npos) {
    const auto [metric, target] = split_metric(key);
    return is_target_name(target) && is_of_cavity(metric) ? metric_from_key(metric) : std::nullopt;
  }
  for (const MetricKey& metric : kMetricKeys) {
    if (metric.key == key) return metric;
  }
  if (key.starts_with(kRemoved)) {
    const auto tissue = scenario_tissue_from_key(key.substr(kRemoved.size()));
    if (tissue && *tissue != Tissue::empty) return MetricKey{key, "mm3"};
  }
  return std::nullopt;
}

Phenomena phenomena_from_keys(const std::vector<std::string>& keys) noexcept {
  Phenomena out;
  for (const std::string& key : keys) {
    if (out.handpiece != Handpiece::none) break;
    if (key == "spindle-turbine") out.handpiece = Handpiece::turbine;
    if (key == "spindle-electric") out.handpiece = Handpiece::electric;
    if (key == "spindle-slow") out.handpiece = Handpiece::slow;
  }
  out.vibration = has_phenomenon(keys, "vibration") && out.handpiece != Handpiece::none;
  out.heat = has_phenomenon(keys, "heat");
  return out;
}

bool needs_heat(std::string_view key) noexcept {
  return key == "dry_cutting" || key == "dry_cutting_time" || key == "temperature_rise_peak";
}

std::optional<Tissue> scenario_tissue_from_key(std::string_view key) noexcept {
  if (const auto known = tissue_from_key(key)) return known;
  for (std::size_t i = 0; i < kOwnKeys.size(); ++i) {
    if (kOwnKeys[i] == key) return static_cast<Tissue>(kFirstOwn + i);
  }
  return std::nullopt;
}

std::string_view key_of_scenario_tissue(Tissue tissue) noexcept {
  const std::size_t code = index_of(tissue);
  if (code < kTissueKeys.size()) return kTissueKeys[code];
  assert(code >= kFirstOwn && code < kTissueCodes);
  return kOwnKeys[code - kFirstOwn];
}

}  // namespace cusp::scenarios
