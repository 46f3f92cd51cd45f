// Names of tissues: the author's own before "Material 1".
#include <gtest/gtest.h>

#include "scenarios/teeth/own_tissues.h"
#include "tests/modules.h"
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

}  // namespace
}  // namespace cusp::test
