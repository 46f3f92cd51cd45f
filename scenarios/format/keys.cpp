#include "scenarios/format/keys.h"

#include <cassert>

namespace cusp::scenarios {
namespace {

constexpr std::string_view kRemoved = "removed_";
constexpr std::array<std::string_view, 16> kOwnKeys = {"16", "17", "18", "19", "20", "21", "22", "23",
                                                       "24", "25", "26", "27", "28", "29", "30", "31"};
constexpr std::size_t kFirstOwn = 16;

}  // namespace

std::optional<MetricKey> metric_from_key(std::string_view key) noexcept {
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
