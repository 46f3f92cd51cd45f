// How a report names a tissue of an author's own volume, and where a protected part was damaged.

#include <gtest/gtest.h>

#include "scenarios/teeth/landmarks.h"
#include "tests/modules.h"
#include "tests/ui/named_block.h"
#include "tests/ui/report/sample_report.h"
#include "ui/report/against_before.h"
#include "ui/report/criteria_model.h"
#include "ui/report/report_text.h"

namespace cusp::test {
namespace {

std::string unmarked(QString text) {
  for (const char16_t c : {u'\x2066', u'\x2069'}) text.remove(QChar(c));
  return text.toStdString();
}

TEST(Report, names_a_tissue_as_the_volume_of_the_attempt_does) {
  ReportData data = sample(70);
  CriterionGrade& first = data.result.grade.criteria[0];
  first.id = "removed_16";
  first.points = 12;
  first.reason_code = "too_little";
  EXPECT_EQ(first_advice(data).head.toStdString(), "Material 1 removed: 26.7 points lost") << "no volume is at hand";
  data.result.volume = std::make_shared<const Volume>(Specimen::build(named_block(), Reading::banded));
  EXPECT_EQ(first_advice(data).head.toStdString(), "pulp stone removed: 26.7 points lost");
  EXPECT_EQ(report_texts(data.result).label(first), "pulp stone removed");
  CriteriaModel model(data.result.grade, data.result.scenario);
  model.set_tissue_names(tissue_names_of(data.result));
  EXPECT_EQ(model.index(0, CriteriaModel::kName).data().toString().toStdString(), "pulp stone removed");
  const AgainstBefore against(data.result.grade, data.result.grade, nullptr, tissue_names_of(data.result));
  EXPECT_EQ(against.rows().front().name.toStdString(), "pulp stone removed");
}

TEST(ReportData, damage_of_a_protected_part_has_the_place_of_what_is_removed_of_it_and_no_depth) {
  ReportData data = sample();
  data.result.scenario = *load_builtin("class-2-46-mo");
  CriterionGrade removed = data.result.grade.criteria[1];
  removed.id = "protected_removed";
  removed.measure = {"protected_removed", true, 0.4, 0.02, "mm3", Vec3(5.0, 0.3, -1.0)};
  data.result.grade.criteria.push_back(removed);
  data.result.grade.critical = {"protected_damage"};
  data.critical = critical_events(data.result.grade, nullptr, {});
  ASSERT_EQ(data.critical.size(), 1u);
  ASSERT_TRUE(data.critical[0].place_mm);
  EXPECT_EQ(*data.critical[0].place_mm, Vec3(5.0, 0.3, -1.0));
  const bool mesial = mesial_x(46) > 0;
  EXPECT_EQ(unmarked(first_advice(data).head), mesial ? "Something protected was damaged, mesial" : "Something protected was damaged, distal");
  EXPECT_EQ(unmarked(first_advice(data).why), "This fails the attempt, whatever its points.");
}

}  // namespace
}  // namespace cusp::test
