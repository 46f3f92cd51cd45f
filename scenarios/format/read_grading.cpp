// What an attempt earns: the rubric.

#include "scenarios/format/keys.h"
#include "scenarios/format/read_sections.h"

namespace cusp::scenarios::format_reader {
namespace {

constexpr Range kBandRange{-1e6, 1e6};

Bands read_bands(const Value& value) {
  Object object(value.node(), value.where(), value.problems());
  Bands out;
  out.fail_lo = object.need("fail_lo").number(kBandRange);
  out.acc_lo = object.need("acc_lo").number(kBandRange);
  out.ideal_lo = object.need("ideal_lo").number(kBandRange);
  out.ideal_hi = object.need("ideal_hi").number(kBandRange);
  out.acc_hi = object.need("acc_hi").number(kBandRange);
  out.fail_hi = object.need("fail_hi").number(kBandRange);
  object.nothing_else();
  return out;
}

}  // namespace

Rubric read_rubric(const Value& value) {
  Object object(value.node(), value.where(), value.problems());
  Rubric out;
  out.pass = object.need("pass").number({0, 100});
  object.need("criteria").list(0, 64, [&](const Value& item) {
    Object one(item.node(), item.where(), item.problems());
    Criterion criterion;
    const Value metric = one.need("metric");
    criterion.metric = metric.key(FormatError::unknown_metric, [](std::string_view key) {
      return metric_from_key(key) ? std::optional<std::string>(key) : std::nullopt;
    });
    for (const Criterion& other : out.criteria) {
      if (other.metric == criterion.metric) metric.refuse(FormatError::duplicate_value, criterion.metric);
    }
    criterion.weight = one.need("weight").number({0, 1000});
    criterion.bands = read_bands(one.need("bands"));
    one.maybe("needs_dof", [&](const Value& v) { criterion.needs_dof = v.integer({3, 6}); });
    one.nothing_else();
    out.criteria.push_back(std::move(criterion));
  });
  object.maybe("critical", [&](const Value& list) {
    list.list(0, 16, [&](const Value& item) {
      out.critical.push_back(item.key(FormatError::unknown_critical, one_of(kCriticalKeys)));
    });
  });
  object.nothing_else();
  return out;
}

}  // namespace cusp::scenarios::format_reader
