#include "ui/view/tooth_cache.h"

#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <fstream>
#include <thread>

#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "ui/render/mesh_blob.h"
#include "ui/render/target_look.h"
#include "ui/session/background_task.h"
#include "ui/session/plan_blob.h"
#include "ui/view/tooth_ahead.h"

namespace cusp::test {
namespace {

namespace fs = std::filesystem;

/// With its target and neighbours, coarse: grown in a second.
ToothWish class_2() {
  ToothWish out;
  out.scenario = load_builtin("class-2-36-do").value();
  out.scenario.specimen.voxel_mm = 0.4;
  return out;
}

class ToothCacheTest : public testing::Test {
 protected:
  std::shared_ptr<const ReadyTooth> ask(const ToothWish& wish) {
    ToothCache cache(place);
    grew = false;
    return *cache.tooth(wish, nullptr, [this](ToothPart part, double share) { grew = grew || (part == ToothPart::specimen && share > 0); });
  }
  QTemporaryDir folder;
  fs::path place = folder.path().toStdString();
  bool grew = false;
};

TEST_F(ToothCacheTest, reads_specimen_and_mesh_as_they_were_made_bit_for_bit) {
  const ToothWish wish = class_2();
  const auto made = ask(wish);
  EXPECT_TRUE(grew);
  const auto read = ask(wish);
  EXPECT_FALSE(grew);
  EXPECT_EQ(read->specimen->hash(), made->specimen->hash());
  const WholeMesh built = PatchFeed::build_mesh(Volume(made->specimen), TargetLook(wish.scenario.target, wish.scenario.leeway, nullptr).feed());
  EXPECT_FALSE(built.patches.empty());
  EXPECT_EQ(mesh_bytes(made->mesh), mesh_bytes(built));
  EXPECT_EQ(mesh_bytes(read->mesh), mesh_bytes(built));
  ASSERT_TRUE(read->reference);
  EXPECT_EQ(&read->reference->specimen(), read->specimen.get());
}

TEST_F(ToothCacheTest, keeps_a_mesh_of_its_own_for_another_target_and_for_silence) {
  ToothWish wish = class_2();
  const auto first = mesh_bytes(ask(wish)->mesh);
  wish.guidance = Guidance::silent;
  EXPECT_NE(mesh_bytes(ask(wish)->mesh), first);
  wish = class_2();
  wish.scenario.target = {};
  EXPECT_NE(mesh_bytes(ask(wish)->mesh), first);
  EXPECT_FALSE(grew) << "the specimen is the same";
}

TEST_F(ToothCacheTest, reads_the_reference_path_as_it_was_planned_and_plans_anew_for_other_burs) {
  ToothWish wish = class_2();
  const auto specimen = ask(wish)->specimen;
  const auto files = [this] { return std::distance(fs::directory_iterator(place), fs::directory_iterator()); };
  const auto before = files();
  const auto planned = ToothCache(place).reference_path(wish, *specimen);
  ASSERT_TRUE(planned.has_value());
  EXPECT_EQ(files(), before + 1);
  const auto read = ToothCache(place).reference_path(wish, *specimen);
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(plan_bytes(*read), plan_bytes(*planned));
  EXPECT_EQ(files(), before + 1);
  wish.scenario.instruments.resize(1);
  (void)ToothCache(place).reference_path(wish, *specimen);
  EXPECT_EQ(files(), before + 2);
}

TEST_F(ToothCacheTest, makes_anew_what_lies_damaged_in_the_folder) {
  const auto made = ask(class_2());
  for (const auto& file : fs::directory_iterator(place)) {
    std::fstream damaged(file.path(), std::ios::in | std::ios::out | std::ios::binary);
    damaged.seekp(static_cast<std::streamoff>(file.file_size() / 2));
    damaged.write("damaged", 7);
  }
  const auto again = ask(class_2());
  EXPECT_TRUE(grew);
  EXPECT_EQ(again->specimen->hash(), made->specimen->hash());
  EXPECT_EQ(mesh_bytes(again->mesh), mesh_bytes(made->mesh));
}

TEST_F(ToothCacheTest, gives_all_who_ask_at_once_the_same_tooth_and_keeps_it_in_memory) {
  ToothCache cache(place);
  const ToothWish wish = class_2();
  std::array<std::shared_ptr<const ReadyTooth>, 3> got;
  {
    std::vector<std::jthread> askers;
    for (auto& one : got) askers.emplace_back([&] { one = *cache.tooth(wish, nullptr); });
  }
  EXPECT_EQ(got[0], got[1]);
  EXPECT_EQ(got[0], got[2]);
  EXPECT_EQ(*cache.tooth(wish, nullptr), got[0]);
}

TEST_F(ToothCacheTest, stops_when_it_is_asked_to_and_whoever_waits_for_the_same_tooth_gets_it_all_the_same) {
  const auto cache = std::make_shared<ToothCache>(place);
  const ToothWish wish = class_2();
  const std::atomic<bool> stop{true};
  const auto stopped = cache->tooth(wish, &stop);
  ASSERT_FALSE(stopped);
  EXPECT_EQ(std::get<ImportError>(stopped.error().cause), ImportError::cancelled);
  { const ToothAhead left_at_once(cache, wish); }
  EXPECT_TRUE(cache->tooth(wish, nullptr));
  wait_for_dropped_tasks();
}

TEST_F(ToothCacheTest, what_was_made_ahead_is_there_at_once) {
  const auto cache = std::make_shared<ToothCache>(place);
  const ToothWish wish = class_2();
  const ToothAhead ahead(cache, wish);
  const auto first = cache->tooth(wish, nullptr);
  ASSERT_TRUE(first);
  const auto second = cache->tooth(wish, nullptr, [](ToothPart, double) { ADD_FAILURE() << "nothing is to be done"; });
  EXPECT_EQ(*second, *first);
}

TEST_F(ToothCacheTest, begins_with_the_specimen_that_is_given_and_keeps_nothing_of_it) {
  ToothWish wish = class_2();
  wish.specimen = ask(wish)->specimen;
  fs::remove_all(place);
  const auto made = ask(wish);
  EXPECT_EQ(made->specimen, wish.specimen);
  EXPECT_FALSE(fs::exists(place));
}

}  // namespace
}  // namespace cusp::test
