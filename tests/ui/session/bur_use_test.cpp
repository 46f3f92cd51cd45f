#include "tests/modules.h"
#include "ui/session/bur_use.h"

#include <gtest/gtest.h>

namespace cusp::test {
namespace {

std::vector<StepInput> inputs(std::uint16_t bur, int count, std::uint16_t buttons, std::uint32_t each_us = 1000) {
  StepInput one;
  one.bur = bur;
  one.buttons = buttons;
  one.elapsed_us = each_us;
  return std::vector<StepInput>(static_cast<std::size_t>(count), one);
}

TEST(BurUse, shows_each_bur_from_when_it_was_taken_to_when_another_was) {
  BurUse use;
  use.add(inputs(0, 300, 0));
  use.add(inputs(0, 200, StepInput::kCut));
  use.add(inputs(2, 100, StepInput::kCut));
  use.add(inputs(0, 50, 0, 4000));
  const std::vector<BurSpan> expected = {{0, 0, 500'000, 200'000}, {2, 500'000, 600'000, 100'000}, {0, 600'000, 800'000, 0}};
  EXPECT_EQ(use.spans(), expected);
}

TEST(BurUse, comes_to_the_same_second_by_second) {
  std::vector<StepInput> all = inputs(1, 70, StepInput::kCut);
  for (const StepInput& input : inputs(3, 90, 0)) all.push_back(input);
  BurUse at_once, in_parts;
  at_once.add(all);
  for (std::size_t i = 0; i < all.size(); i += 16)
    in_parts.add(std::span(all).subspan(i, std::min<std::size_t>(16, all.size() - i)));
  EXPECT_EQ(at_once.spans(), in_parts.spans());
  EXPECT_TRUE(BurUse().spans().empty());
}

}  // namespace
}  // namespace cusp::test
