#include "ui/editor/first_bands.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "engine/removal/heat.h"
#include "scenarios/format/keys.h"
#include "scenarios/grading/default_bands.h"
#include "scenarios/library/library.h"
#include "scenarios/shapes/outline_size.h"
#include "ui/editor/band_scale.h"
#include "ui/text/grade_text.h"

namespace cusp::ui {
namespace {

/// One of several targets by its name; the whole target for any other name.
const Region& target_of(const Region& whole, std::string_view name) {
  for (const Region* one : named_targets(whole))
    if (one->name == name) return *one;
  return whole;
}

Bands shifted(const Bands& bands, double by) {
  return with_edges(bands, [by](double edge) { return edge + by; });
}

/// The criterion whose bands a new one takes: over-cut of one face that of all its kind, the shallowest floor the mean one.
std::string pattern_of(const std::string& metric) {
  if (metric == "depth_least") return "depth_mean";
  for (const std::string_view start : {"overcut_leeway_", "overcut_beyond_"})
    if (metric.starts_with(start)) return std::string(start) + (metric.ends_with("_floor") ? "floor" : "side");
  return metric;
}

}  // namespace

double isthmus_mm(const Outline& outline) { return outline.shape == "box" ? outline.box_size_mm.y : outline.width_mm; }

Bands fitted_bands(const Bands& bands, const std::string& metric, const Outline& target, const Outline& pattern) {
  if (metric.starts_with("depth_")) return shifted(bands, target.depth_mm - pattern.depth_mm);
  if (!metric.starts_with("overcut_")) return bands;
  const OutlineSize here = size_of(target), there = size_of(pattern);
  const double by = metric.ends_with("_floor") ? here.floor_mm2 / there.floor_mm2 : here.wall_mm2 / there.wall_mm2;
  return by > 0.0 ? with_edges(bands, [by](double edge) { return std::round(100.0 * edge * by) / 100.0; }) : bands;
}

Bands first_bands(const std::string& of, const Region& whole, int fdi) {
  const std::string metric(split_metric(of).metric);
  const Region& target = target_of(whole, split_metric(of).target);
  if (const auto offered = default_bands(metric, fdi)) {
    if (metric != "isthmus_width" || target.kind != RegionKind::outline) return *offered;
    return shifted(*offered, isthmus_mm(target.outline) - 0.5 * (offered->ideal_lo + offered->ideal_hi));
  }
  for (const std::string_view key : {"class-1-36", "channel-1", "paper-block"}) {
    const auto known = load_builtin(key);
    if (!known) continue;
    for (const Criterion& c : known->rubric.criteria) {
      if (c.metric != pattern_of(metric)) continue;
      // A tree has no depth of its own before it is measured: the bands stay those of the pattern.
      return target.kind == RegionKind::outline ? fitted_bands(c.bands, metric, target.outline, known->target.outline) : c.bands;
    }
  }
  // Coolant: nothing missing is ideal; the pulp's temperature criterion is the worst edge [M].
  if (metric == "dry_cutting_time") return {0, 0, 0, 2, 5, 10};
  if (metric == "temperature_rise_peak") return {0, 0, 0, 2, 4, kPulpCriterionK};
  const auto known = metric_from_key(metric);
  const double end = band_end(metric_unit(metric).toStdString());
  const double least = known ? known->least : 0, most = known ? std::min(known->most, end) : end;
  return {least, least, least, most, most, most};
}

}  // namespace cusp::ui
