// Names of tissues: the author's own before "Material 1".
#include <gtest/gtest.h>

#include "scenarios/teeth/own_tissues.h"
#include "tests/modules.h"
#include "ui/text/audit_text.h"
#include "ui/text/grade_text.h"
#include "ui/text/names.h"

namespace cusp::test {
namespace {

TEST(TissueNames, are_those_that_the_volume_gives) {
  const TissueNames own = {{16, "pulp stone"}, {17, ""}, {29, "root filling"}};
  EXPECT_EQ(tissue_name(static_cast<Tissue>(16), own).toStdString(), "pulp stone");
  EXPECT_EQ(tissue_name(static_cast<Tissue>(17), own), tissue_name(static_cast<Tissue>(17))) << "an empty name is none";
  EXPECT_EQ(tissue_name(static_cast<Tissue>(18), own), tissue_name(static_cast<Tissue>(18)));
  EXPECT_EQ(tissue_name(kNeighbourEnamel, own).toStdString(), "root filling") << "a file names the code as it likes";
  EXPECT_EQ(tissue_name(Tissue::enamel, own), tissue_name(Tissue::enamel));
}

TEST(TissueNames, of_a_grown_tooth_are_in_the_language_of_the_interface) {
  for (const auto& [code, name] : own_tissue_names()) {
    const auto tissue = static_cast<Tissue>(code);
    EXPECT_EQ(tissue_name(tissue, own_tissue_names()), tissue_name(tissue)) << name;
  }
}

TEST(TissueNames, of_the_volume_stand_in_the_names_of_criteria) {
  const TissueNames own = {{16, "pulp stone"}};
  EXPECT_EQ(metric_name("removed_16", nullptr, own).toStdString(), "pulp stone removed");
  EXPECT_EQ(metric_name("removed_16").toStdString(), "Material 1 removed");
  EXPECT_EQ(metric_name("removed_17", nullptr, own).toStdString(), "Material 2 removed");
  EXPECT_EQ(metric_name("removed_enamel", nullptr, own).toStdString(), "Enamel removed");
  EXPECT_EQ(metric_name("removed_16@pit", nullptr, own).toStdString(), "pulp stone removed (Pit)");
  EXPECT_EQ(metric_name("removed_99", nullptr, own).toStdString(), "removed_99") << "no tissue has the code";
  CriterionGrade lost;
  lost.id = "removed_16";
  EXPECT_EQ(lost_text(lost, 1, nullptr, own).toStdString(), "pulp stone removed: 1 point lost");
  GradeChanges changes;
  changes.criteria.emplace_back().id = "removed_16";
  EXPECT_TRUE(changes_text(changes, nullptr, own).contains(QStringLiteral("pulp stone removed")));
}

TEST(TissueNames, of_the_volume_stand_among_the_choices_of_an_audit) {
  const Choice left_out{Aspect::tissue, "16", 1, 0};
  EXPECT_EQ(choice_name(left_out, {{16, "pulp stone"}}).toStdString(), "pulp stone left out");
  EXPECT_EQ(choice_name(left_out).toStdString(), "Material 1 left out");
}

}  // namespace
}  // namespace cusp::test
