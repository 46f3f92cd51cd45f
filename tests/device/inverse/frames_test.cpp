// Reports of the service, as public clients read them, and damaged ones.
#include "device/inverse/frames.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>

namespace cusp::device::inverse {
namespace {

constexpr const char* kFirst = R"({"inverse3":[{"device_id":"049D","config":{"handedness":"left","type":"inverse3"},
  "state":{"cursor_position":{"x":0.01,"y":-0.12,"z":0.2},"cursor_velocity":{"x":0,"y":0,"z":0}}}],
  "wireless_verse_grip":[{"device_id":"61573","state":{"orientation":{"x":0,"y":0,"z":0.6,"w":0.8},
  "buttons":{"a":true,"b":false,"c":true}}}]})";

TEST(InverseFrames, place_orientation_and_buttons_are_read) {
  const auto frame = parse_frame(kFirst);
  ASSERT_TRUE(frame);
  ASSERT_EQ(frame->devices.size(), 1u);
  EXPECT_EQ(frame->devices[0].id, "049D");
  EXPECT_TRUE(frame->devices[0].left_handed);
  EXPECT_EQ(frame->devices[0].position_m, Vec3(0.01, -0.12, 0.2));
  ASSERT_TRUE(frame->orientation);
  EXPECT_DOUBLE_EQ(frame->orientation->w, 0.8);
  EXPECT_DOUBLE_EQ(frame->orientation->z, 0.6);
  EXPECT_TRUE(frame->a);
  EXPECT_FALSE(frame->b);
  EXPECT_TRUE(frame->c);
}

TEST(InverseFrames, what_is_missing_is_missing_and_no_failure) {
  EXPECT_TRUE(parse_frame("{}")->devices.empty());
  EXPECT_TRUE(parse_frame(R"({"inverse3":null,"wireless_verse_grip":[]})")->devices.empty());
  const auto bare = parse_frame(R"({"inverse3":[{"device_id":"1"}]})");
  ASSERT_TRUE(bare);
  EXPECT_FALSE(bare->devices[0].position_m);
  EXPECT_FALSE(parse_frame(R"({"inverse3":[{"device_id":"1","state":{"cursor_position":{}}}]})")->devices[0].position_m);
  // A handle that is asleep reports zeros.
  EXPECT_FALSE(parse_frame(R"({"wireless_verse_grip":[{"state":{"orientation":{"x":0,"y":0,"z":0,"w":0}}}]})")->orientation);
}

TEST(InverseFrames, an_orientation_is_made_a_unit_one) {
  const auto frame = parse_frame(R"({"wireless_verse_grip":[{"state":{"orientation":{"x":0.7,"y":0,"z":0,"w":0.7}}}]})");
  ASSERT_TRUE(frame && frame->orientation);
  EXPECT_NEAR(glm::length(*frame->orientation), 1.0, 1e-12);
}

TEST(InverseFrames, rubbish_is_refused_with_its_kind) {
  const auto code = [](std::string_view text) { return parse_frame(text).error(); };
  EXPECT_EQ(code(""), FrameError::not_json);
  EXPECT_EQ(code("{\"inverse3\":[{"), FrameError::not_json);
  EXPECT_EQ(code("\xff\xfe"), FrameError::not_json);
  EXPECT_EQ(code("[]"), FrameError::no_object);
  EXPECT_EQ(code("7"), FrameError::no_object);
  EXPECT_EQ(code(R"({"inverse3":{}})"), FrameError::wrong_type);
  EXPECT_EQ(code(R"({"inverse3":[7]})"), FrameError::wrong_type);
  EXPECT_EQ(code(R"({"inverse3":[{"state":[]}]})"), FrameError::wrong_type);
  EXPECT_EQ(code(R"({"inverse3":[{"state":{"cursor_position":{"x":1,"y":2}}}]})"), FrameError::wrong_type);
  EXPECT_EQ(code(R"({"inverse3":[{"state":{"cursor_position":{"x":"1","y":2,"z":3}}}]})"), FrameError::wrong_type);
  EXPECT_EQ(code(R"({"inverse3":[{"state":{"cursor_position":{"x":1e300,"y":2,"z":3}}}]})"), FrameError::not_finite);
  EXPECT_EQ(code(R"({"wireless_verse_grip":[{"state":{"orientation":{"x":1}}}]})"), FrameError::wrong_type);
  EXPECT_EQ(code(std::string(kMostBytes + 1, ' ')), FrameError::too_large);
  EXPECT_EQ(code(std::string(60'000, '[')), FrameError::not_json);  // as deep as it may be long
}

TEST(InverseFrames, every_cut_and_many_changes_of_a_real_one_are_read_or_refused) {
  const std::string whole = kFirst;
  for (std::size_t cut = 0; cut < whole.size(); ++cut) EXPECT_FALSE(parse_frame(std::string_view(whole).substr(0, cut)));
  std::mt19937 random(3);
  int read = 0;
  for (int i = 0; i < 100'000; ++i) {
    std::string damaged = whole;
    for (int n = 0; n < 2; ++n) damaged[random() % damaged.size()] = static_cast<char>(random());
    const auto frame = parse_frame(damaged);
    if (!frame) continue;
    ++read;
    for (const auto& device : frame->devices) {
      if (device.position_m) {
        ASSERT_TRUE(std::isfinite(glm::length(*device.position_m)));
      }
    }
  }
  EXPECT_GT(read, 1000);
}

TEST(InverseFrames, a_force_message_has_the_form_that_the_service_expects) {
  const auto json = nlohmann::json::parse(force_message("049D", {0.5, -1.0, 2.0}));
  EXPECT_EQ(json["inverse3"][0]["device_id"], "049D");
  const auto& values = json["inverse3"][0]["commands"]["set_cursor_force"]["values"];
  EXPECT_EQ(values["x"], 0.5);
  EXPECT_EQ(values["y"], -1.0);
  EXPECT_EQ(values["z"], 2.0);
  EXPECT_NO_THROW(force_message("\xff\"}", {0, 0, 0}));
}

}  // namespace
}  // namespace cusp::device::inverse
