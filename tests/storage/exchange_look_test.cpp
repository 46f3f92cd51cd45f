/// What of a file or a key is seen before it changes anything.
#include <gtest/gtest.h>

#include <fstream>

#include "tests/storage/two_stations.h"

namespace cusp::test {
namespace {

namespace fs = std::filesystem;

using LookTest = TwoStations;

TEST_F(LookTest, a_look_says_whose_a_file_is_and_what_it_carries_and_changes_nothing) {
  must(trust(office->context(), chief, must(public_key_from(must(own_key(station->context(), keeper)))), KeyRole::station));
  complete_session(*station, make_student(*station, "2", "Omar"), keep(*station), 81.5);
  const fs::path early = results(), file = results();
  const auto before = shared_records(*office);
  const ExchangeLook look = must(look_into(office->context(), chief, file));
  EXPECT_EQ(look.role, KeyRole::station);
  EXPECT_EQ(key_id(look.signer.bytes), station->context().key->id());
  EXPECT_EQ(look.counts.sessions, 1u);
  EXPECT_EQ(look.counts.accounts, 0u) << "known by reference alone";
  EXPECT_EQ(look.newest_read, 0u);
  EXPECT_EQ(shared_records(*office), before);
  must(read_in(office->context(), chief, file));
  EXPECT_EQ(must(look_into(office->context(), chief, early)).newest_read, 2u);
  const auto read = must(files_read_in(office->context(), chief));
  ASSERT_EQ(read.size(), 1u);
  EXPECT_EQ(read.front().number, 2u);
  const auto stranger = open(folder / "stranger.db");
  EXPECT_EQ(must(look_into(stranger->context(), make_administrator(*stranger, "x").actor(), file)).role, std::nullopt);
  EXPECT_EQ(code_of(look_into(station->context(), keeper, file)), StorageError::not_allowed) << "its own";
}

TEST_F(LookTest, a_key_file_holds_the_key_whole_or_is_refused) {
  const SignedText key = must(own_key(station->context(), keeper));
  const auto written = [&](const std::string& text) {
    const fs::path file = next_file();
    std::ofstream(file) << text;
    return file;
  };
  EXPECT_EQ(must(public_key_in(written(key_file_of(key)))).bytes, must(public_key_from(key)).bytes);
  EXPECT_EQ(code_of(public_key_in(written("no key"))), StorageError::bad_value);
  EXPECT_EQ(code_of(public_key_in(written(key_file_of(key).substr(1)))), StorageError::bad_value);
  EXPECT_EQ(code_of(public_key_in(folder / "nothing")), StorageError::not_found);
}

}  // namespace
}  // namespace cusp::test
