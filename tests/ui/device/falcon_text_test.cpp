// The text for what a Falcon does now, and for what keeps it away.
#include <gtest/gtest.h>

#include "device/catalogue.h"
#include "tests/modules.h"
#include "ui/device/homing_view.h"
#include "ui/text/device_text.h"
#include "ui/text/falcon_text.h"

namespace cusp::test {
namespace {

TEST(FalconText, every_phase_and_every_end_has_its_text) {
  for (int phase = 0; phase <= static_cast<int>(falcon::Phase::failed); ++phase) {
    falcon::SessionState state;
    state.phase = static_cast<falcon::Phase>(phase);
    EXPECT_FALSE(phase_text(state).isEmpty()) << phase;
  }
  for (int end = static_cast<int>(falcon::TrialEnd::stopped); end <= static_cast<int>(falcon::TrialEnd::out_of_range); ++end)
    EXPECT_FALSE(end_text(static_cast<falcon::TrialEnd>(end)).isEmpty()) << end;
}

TEST(FalconText, a_falcon_that_is_looked_for_comes_with_the_cause_and_the_way_out) {
  HomingView homing;
  const auto text = [&homing](falcon::Phase phase, falcon::Trouble trouble) {
    FalconView view;
    view.session.phase = phase;
    view.session.trouble = trouble;
    homing.show_falcon(view);
    return homing.text();
  };
  using falcon::Phase;
  using falcon::Trouble;
  EXPECT_EQ(text(Phase::unplugged, Trouble::absent).trimmed(), "Looking for it");
  for (const Phase phase : {Phase::unplugged, Phase::opening}) {
    EXPECT_TRUE(text(phase, Trouble::denied).contains(QStringLiteral("may not open it"))) << static_cast<int>(phase);
    EXPECT_TRUE(text(phase, Trouble::denied).contains(QStringLiteral("Device page"))) << static_cast<int>(phase);
    EXPECT_TRUE(text(phase, Trouble::busy).contains(QStringLiteral("Another program holds it"))) << static_cast<int>(phase);
  }
  EXPECT_TRUE(text(Phase::failed, Trouble::no_hello).contains(QStringLiteral("power adapter")));
  EXPECT_TRUE(text(Phase::failed, Trouble::no_answer).contains(QStringLiteral("power plug")));
  EXPECT_FALSE(text(Phase::settling, Trouble::no_answer).contains(QStringLiteral("power plug"))) << "the next attempt mostly succeeds";
  EXPECT_TRUE(text(Phase::needs_image, Trouble::none).contains(QStringLiteral("name the file")));
}

TEST(FalconText, a_screen_reader_hears_what_the_hand_has_to_do_and_not_the_phase_alone) {
  HomingView homing;
  FalconView view;
  view.session.phase = falcon::Phase::homing;
  homing.show_falcon(view);
  EXPECT_TRUE(homing.accessibleDescription().startsWith(QStringLiteral("Finding its middle"))) << homing.accessibleDescription().toStdString();
  EXPECT_TRUE(homing.accessibleDescription().contains(QStringLiteral("Pull the grip"))) << homing.accessibleDescription().toStdString();
  view.session.phase = falcon::Phase::uploading;
  view.session.upload_size = 100;
  homing.show_falcon(view);
  const QString begun = homing.accessibleDescription();
  EXPECT_TRUE(begun.startsWith(QStringLiteral("Loading its firmware"))) << begun.toStdString();
  view.session.uploaded = 50;
  homing.show_falcon(view);
  EXPECT_TRUE(homing.text().contains(QStringLiteral("50"))) << homing.text().toStdString();
  EXPECT_EQ(homing.accessibleDescription(), begun) << "a voice would never pause";
}

TEST(FalconText, answers_that_come_too_late_are_the_cause_that_is_named) {
  const Message late = describe_falcon({PortError::io, "FT000001", "late_answers"});
  EXPECT_EQ(late.what, "The Falcon answers too late.");
  EXPECT_TRUE(late.more.contains(QStringLiteral("USB socket")));
}

TEST(FalconText, a_falcon_that_nobody_named_is_called_one) {
  EXPECT_TRUE(describe_falcon({PortError::not_found, {}, "absent"}).more.contains(QStringLiteral("Falcon")));
  EXPECT_TRUE(describe_falcon({PortError::not_found, "FT000001", "absent"}).more.contains(QStringLiteral("FT000001")));
}

TEST(FalconText, a_falcon_that_may_not_be_opened_is_named_with_the_way_out) {
  const Message denied = describe_falcon({PortError::no_permission, "FT000001", "denied"});
  EXPECT_TRUE(denied.more.contains(QStringLiteral("FT000001"))) << denied.more.toStdString();
  EXPECT_TRUE(denied.more.contains(QStringLiteral("Device page"))) << denied.more.toStdString();
}

TEST(FalconText, firmware_that_is_lacking_is_no_script) {
  const SessionFailure lacking{.code = SessionError::device, .where = "FT000001", .detail = "needs_image", .cause = PortError::bad_file};
  EXPECT_EQ(describe_on_device(lacking, "falcon").what, "The Falcon needs its firmware file.");
  const SessionFailure broken{.code = SessionError::device, .where = "script.csv", .detail = "empty", .cause = PortError::bad_file};
  EXPECT_EQ(describe_on_device(broken, "scripted").what, "The script cannot be read.");
}

TEST(DeviceText, a_driver_that_does_not_come_back_is_named_as_such_for_each_device) {
  for (const DeviceKind& kind : device_kinds()) {
    const SessionFailure failure{.code = SessionError::device, .where = "Novint Falcon", .detail = std::string(kStandsStill), .cause = PortError::io};
    const Message still = describe_on_device(failure, kind.key);
    EXPECT_EQ(still.what, "The driver of the device stands still.") << kind.key;
    EXPECT_TRUE(still.more.contains(QStringLiteral("Novint Falcon"))) << still.more.toStdString();
  }
}

TEST(DeviceText, a_device_that_an_exercise_does_not_admit_is_named_with_the_way_to_another) {
  for (const SessionError why : {SessionError::device_class, SessionError::device_axes}) {
    const Message refused = describe_on_device({.code = why, .where = "pointer", .detail = "6"}, "pointer");
    EXPECT_TRUE(refused.more.contains(QStringLiteral("Mouse and keys"))) << refused.more.toStdString();
    EXPECT_TRUE(refused.more.contains(QStringLiteral("page Device"))) << refused.more.toStdString();
  }
}

TEST(DeviceText, a_service_that_is_absent_and_one_without_an_inverse3_are_different_causes) {
  const SessionFailure no_service{.code = SessionError::device, .where = "service", .cause = PortError::not_found};
  const SessionFailure no_device{.code = SessionError::device, .where = "device", .cause = PortError::not_found};
  EXPECT_EQ(describe_on_device(no_service, "inverse3").what, "The service of the Inverse3 does not answer.");
  EXPECT_EQ(describe_on_device(no_device, "inverse3").what, "The Inverse3 was not found.");
  const SessionFailure garbage{.code = SessionError::device, .where = "service", .detail = "garbage", .cause = PortError::io};
  EXPECT_TRUE(describe_on_device(garbage, "inverse3").more.contains(QStringLiteral("garbage")));
}

}  // namespace
}  // namespace cusp::test
