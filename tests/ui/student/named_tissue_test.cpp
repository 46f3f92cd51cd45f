// How the start page names a tissue of an author's own volume.
#include <gtest/gtest.h>

#include <QLabel>
#include <algorithm>
#include <filesystem>

#include "scenarios/import/nrrd.h"
#include "tests/modules.h"
#include "tests/ui/named_block.h"
#include "tests/ui/student/start_page_cards.h"
#include "ui/session/file_bytes.h"

namespace cusp::test {
namespace {

TEST_F(StartPageCards, advice_names_a_tissue_as_the_volume_does) {
  const std::filesystem::path folder = cache.path().toStdString();
  ASSERT_TRUE(write_nrrd(named_block(), folder / "block.nrrd"));
  const auto bytes = bytes_of(folder / "block.nrrd");
  ASSERT_TRUE(bytes);
  Store& store = records.store();
  const auto hash = store.blobs.put(*bytes);
  ASSERT_TRUE(hash);
  Scenario imported = *load_builtin("channel-1");
  imported.specimen = {};
  imported.specimen.volume = "block.nrrd";
  ASSERT_TRUE(store.scenarios.publish(examiner, imported, canonical_json(imported), content_hash(imported).bytes, {{"block.nrrd", *hash}}));
  Grade grade = sample_grade(80);
  grade.criteria[1].id = "removed_16";
  grade.criteria[1].reason_code = "too_much";
  records.graded_attempt(lena, "channel-1", grade, 300);
  const StartPage start(store, lena, pictures, now, "pointer", folder);
  const QList<QLabel*> labels = start.findChildren<QLabel*>();
  EXPECT_TRUE(std::ranges::any_of(labels, [](const QLabel* label) { return label->text().contains(QStringLiteral("<b>pulp stone removed:</b>")); }));
}

}  // namespace
}  // namespace cusp::test
