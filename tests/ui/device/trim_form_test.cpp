// The form of a Falcon's trim: what it shows under the hand, and what it takes back.
#include <gtest/gtest.h>

#include <QComboBox>

#include "tests/modules.h"
#include "tests/ui/device/shown_parts.h"
#include "ui/device/trim_form.h"
#include "ui/widgets/chip.h"
#include "ui/widgets/number_field.h"

namespace cusp::test {
namespace {

/// A Falcon's view with the grip there, homed.
FalconView grip_at(Vec3 place_m, std::uint8_t buttons = 0) {
  FalconView view;
  view.session.phase = falcon::Phase::ready;
  view.session.buttons = buttons;
  view.grip_m = place_m;
  return view;
}

TEST(TrimForm, shows_under_the_hand_what_the_numbers_do) {
  TrimForm form;
  form.show_grip(grip_at({0.010, 0.004, 0.125 - 0.006}));
  EXPECT_TRUE(shows(form, QStringLiteral("right 5.0 mm, up 2.0 mm, nearer -3.0 mm")) ||
              shows(form, QStringLiteral("5.0")));  // half of the hand's way
  button(form, QStringLiteral("As it stands now"))->click();
  const FalconTrim here = form.trim();
  EXPECT_LT(glm::length(here.centre_m - Vec3(0.010, 0.004, 0.119)), 1e-12);
  form.findChild<NumberField*>()->setValue(12);  // what is typed afterwards is a step of its own
  ASSERT_NE(form.trim(), here);
  form.undo();
  EXPECT_EQ(form.trim(), here);
  form.show_grip(grip_at({0.010, 0.004, 0.119}));
  EXPECT_FALSE(shows(form, QStringLiteral("5.0")));
  // The clutch holds the bur while the grip moves, and the bur then moves from there.
  form.show_grip(grip_at({0.010, 0.004, 0.119}, falcon::status::kForward));
  form.show_grip(grip_at({0.040, 0.004, 0.119}, falcon::status::kForward));
  EXPECT_TRUE(form.findChild<Chip*>()->isVisibleTo(&form));
  EXPECT_FALSE(shows(form, QStringLiteral("15.0")));
  form.show_grip(grip_at({0.040, 0.004, 0.119}));
  form.show_grip(grip_at({0.044, 0.004, 0.119}));
  EXPECT_TRUE(shows(form, QStringLiteral("2.0")));
  EXPECT_FALSE(form.findChild<Chip*>()->isVisibleTo(&form));
  form.hide_grip();
  EXPECT_TRUE(shows(form, QStringLiteral("–")));
  EXPECT_FALSE(button(form, QStringLiteral("As it stands now"))->isEnabled());
}

TEST(TrimForm, each_field_s_steps_are_one_and_all_can_be_taken_back_to_the_start) {
  TrimForm form;
  const FalconTrim began{.centre_m = Vec3(0.001, 0, 0.125), .scale = 0.4};
  form.set_trim(began);
  int changes = 0;
  QObject::connect(&form, &TrimForm::changed, [&changes] { ++changes; });
  NumberField* scale = form.findChildren<NumberField*>()[3];
  for (int percent = 41; percent <= 60; ++percent) scale->setValue(percent);
  form.findChildren<NumberField*>()[4]->setValue(130);
  auto* clutch = form.findChild<QComboBox*>();
  clutch->setCurrentIndex(3);
  Q_EMIT clutch->activated(3);
  EXPECT_EQ(form.trim().clutch, 0);
  form.reset();
  EXPECT_EQ(form.trim(), FalconTrim{});
  EXPECT_EQ(changes, 20 + 1 + 1 + 1);
  for (int step = 0; step < 4; ++step) form.undo();
  EXPECT_EQ(form.trim(), began);
  form.undo();  // there is nothing more
  EXPECT_EQ(form.trim(), began);
  EXPECT_EQ(changes, 20 + 1 + 1 + 1 + 4);
}

}  // namespace
}  // namespace cusp::test
