#include "ui/editor/target_names.h"

#include <QString>
#include <algorithm>

#include "scenarios/format/keys.h"

namespace cusp::ui {
namespace {

constexpr qsizetype kMostOfName = 24;  // of a title; a number may follow

bool has_target(const Region& whole, std::string_view name) {
  return std::ranges::any_of(named_targets(whole), [name](const Region* one) { return one->name == name; });
}

/// "mesial_pit" of "Mesial pit"; letters beyond a to z lose their marks or go.
std::string name_of(const std::string& title, const Region& whole) {
  QString stem;
  for (const QChar c : QString::fromStdString(title).toLower().normalized(QString::NormalizationForm_KD)) {
    if ((c >= u'a' && c <= u'z') || (!stem.isEmpty() && c >= u'0' && c <= u'9')) stem += c;
    else if (!c.isMark() && !stem.isEmpty() && !stem.endsWith(u'_')) stem += u'_';
  }
  stem.truncate(kMostOfName);
  while (stem.endsWith(u'_')) stem.chop(1);
  if (stem.isEmpty()) stem = u"target"_qs;
  QString name = stem;
  for (int n = 2; has_target(whole, name.toStdString()); ++n) name = u"%1_%2"_qs.arg(stem).arg(n);
  return name.toStdString();
}

void clear_name(Region& part) {
  part.name.clear();
  part.title.clear();
}

void clear_below(Region& region) {
  for (Region& part : region.parts) {
    clear_name(part);
    clear_below(part);
  }
}

/// Criteria of the one target that is left become those of the whole. A criterion that the whole has already stays as it is.
void measure_as_whole(Rubric& rubric, const std::string& name) {
  for (Criterion& c : rubric.criteria) {
    const auto [metric, target] = scenarios::split_metric(c.metric);
    const std::string of_whole(metric);
    if (target == name && std::ranges::find(rubric.criteria, of_whole, &Criterion::metric) == rubric.criteria.end()) c.metric = of_whole;
  }
}

}  // namespace

bool can_be_target(const Region& whole, const PartPath& path) {
  return whole.kind == RegionKind::joined && path.size() == 1 && part_at(whole, path) != nullptr;
}

void set_target_title(Region& part, const Region& whole, const std::string& language, const std::string& text) {
  if (text.empty()) {
    part.title.erase(language);
    if (part.title.empty()) return clear_name(part);
  } else {
    part.title[language] = text;
  }
  if (!part.title.contains("en")) part.title["en"] = part.title.begin()->second;
  if (part.name.empty()) part.name = name_of(text, whole);
}

void settle_targets(const Scenario& before, Scenario& after) {
  Region& whole = after.target;
  if (!whole.name.empty()) measure_as_whole(after.rubric, whole.name);  // the one part that is left has become the root
  clear_name(whole);
  if (whole.kind == RegionKind::joined) std::ranges::for_each(whole.parts, clear_below);
  else clear_below(whole);
  std::erase_if(after.rubric.criteria, [&](const Criterion& c) {
    const std::string_view name = scenarios::split_metric(c.metric).target;
    return !name.empty() && has_target(before.target, name) && !has_target(whole, name);
  });
}

}  // namespace cusp::ui
