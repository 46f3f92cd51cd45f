#include "storage/cache/key_state_cache.h"

#include <gtest/gtest.h>

#include <sys/stat.h>

#include <fstream>
#include <random>

#include "tests/modules.h"
#include "tests/storage/sample.h"

namespace cusp::test {
namespace {

namespace fs = std::filesystem;

class KeyStatesTest : public ::testing::Test {
 protected:
  /// Bytes that do not pack.
  static KeyState state_at(std::uint64_t tick, std::size_t bytes = 2000) {
    KeyState state{tick, std::vector<std::byte>(bytes), {std::byte{1}, static_cast<std::byte>(tick)}};
    std::mt19937 noise(static_cast<unsigned>(tick));
    for (std::byte& byte : state.state) byte = static_cast<std::byte>(noise());
    return state;
  }
  std::vector<fs::path> files() const {
    std::vector<fs::path> out;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(cache.folder(), none)) out.push_back(entry.path());
    return out;
  }
  fs::path file_of(SessionId id, std::uint64_t tick) const {
    for (const fs::path& file : files()) {
      if (file.string().find(id.text() + "-" + std::string(12 - std::to_string(tick).size(), '0') + std::to_string(tick)) !=
          std::string::npos) {
        return file;
      }
    }
    return {};
  }

  Folder folder;
  std::unique_ptr<Store> store = open(folder / "a.db");
  KeyStateCache& cache = store->key_states;
  SessionId session = SessionId::make(), other = SessionId::make();
};

TEST_F(KeyStatesTest, of_a_running_session_the_newest_two_are_kept_and_come_back_to_the_byte) {
  for (const std::uint64_t tick : {5000, 10'000, 15'000, 20'000}) must(cache.keep_live(session, state_at(tick)));
  must(cache.keep_live(other, state_at(5000)));
  EXPECT_EQ(cache.ticks(session), (std::vector<std::uint64_t>{15'000, 20'000}));
  EXPECT_EQ(cache.ticks(other), std::vector<std::uint64_t>{5000});
  const auto back = cache.read(session, 15'000);
  ASSERT_TRUE(back);
  EXPECT_EQ(back->state, state_at(15'000).state);
  EXPECT_EQ(back->process, state_at(15'000).process);
  EXPECT_FALSE(cache.read(session, 10'000));
}

TEST_F(KeyStatesTest, only_the_owner_can_read_a_file_and_none_lies_in_the_database) {
  must(cache.keep_live(session, state_at(5000)));
  ASSERT_EQ(files().size(), 1u);
  EXPECT_EQ(fs::status(files()[0]).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_EQ(cache.folder(), folder / "a.db.states");
  EXPECT_EQ(must(store->database().first("SELECT count(*) FROM key_states", [](Row row) { return row.integer(0); })), 0);
}

TEST_F(KeyStatesTest, a_file_with_any_byte_changed_or_cut_off_is_ignored_and_removed) {
  const unsigned seed = 20261121;
  RecordProperty("seed", static_cast<int>(seed));
  std::mt19937 dice(seed);
  for (int n = 0; n < 60; ++n) {
    must(cache.keep_live(session, state_at(5000)));
    const fs::path file = file_of(session, 5000);
    std::string bytes;
    {
      std::ifstream in(file, std::ios::binary);
      bytes.assign(std::istreambuf_iterator<char>(in), {});
    }
    const std::size_t at = dice() % bytes.size();
    if (n % 3 == 0) {
      bytes.resize(at);
    } else if (n % 3 == 1) {
      bytes[at] = static_cast<char>(bytes[at] ^ (1 << dice() % 8));
    } else {
      bytes.insert(at, 1, 'x');
    }
    std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
    EXPECT_FALSE(cache.read(session, 5000)) << "change " << n << " at " << at << ", seed " << seed;
    EXPECT_FALSE(fs::exists(file));
  }
}

TEST_F(KeyStatesTest, a_file_shorter_than_its_header_and_seal_is_ignored_and_removed) {
  must(cache.keep_live(session, state_at(5000)));
  const fs::path file = file_of(session, 5000);
  std::string bytes(80, '\0');  // header 40, seal 32: some lengths are shorter than the seal, than both, and longer
  ASSERT_TRUE(std::ifstream(file, std::ios::binary).read(bytes.data(), 80));
  for (std::size_t keep = 0; keep <= bytes.size(); ++keep) {
    std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes.substr(0, keep);
    EXPECT_FALSE(cache.read(session, 5000)) << keep;
    EXPECT_FALSE(fs::exists(file)) << keep;
  }
}

TEST_F(KeyStatesTest, one_of_another_session_tick_or_station_is_not_believed) {
  must(cache.keep_live(other, state_at(5000)));
  const std::string digits = "-000000005000.live";
  const fs::path foreign = cache.folder() / (other.text() + digits), own = cache.folder() / (session.text() + digits);
  fs::copy_file(foreign, own);
  EXPECT_FALSE(cache.read(session, 5000));
  fs::copy_file(foreign, cache.folder() / (other.text() + "-000000006000.live"));
  EXPECT_FALSE(cache.read(other, 6000));
  const auto second = open(folder / "b.db");
  must(second->key_states.keep_live(session, state_at(5000)));
  fs::copy_file(second->key_states.folder() / (session.text() + digits), own);
  EXPECT_FALSE(cache.read(session, 5000));
  EXPECT_TRUE(cache.read(other, 5000)) << "what belongs there is untouched";
}

TEST_F(KeyStatesTest, a_link_a_folder_and_a_pipe_under_a_files_name_are_ignored) {
  const auto name = [&](std::uint64_t tick) {
    return cache.folder() / (session.text() + "-00000000" + std::to_string(tick) + ".live");
  };
  must(cache.keep_live(session, state_at(5000)));
  fs::rename(name(5000), folder / "elsewhere");
  fs::create_symlink(folder / "elsewhere", name(5000));
  EXPECT_FALSE(cache.read(session, 5000));
  fs::create_directory(name(6000));
  EXPECT_FALSE(cache.read(session, 6000));
  EXPECT_EQ(mkfifo(name(7000).c_str(), 0600), 0);
  EXPECT_FALSE(cache.read(session, 7000));
}

TEST_F(KeyStatesTest, the_oldest_go_first_and_what_a_running_session_needs_goes_last) {
  must(cache.keep_live(other, state_at(5000, 10'000)));
  const auto past = fs::file_time_type::clock::now() - std::chrono::hours(100);
  fs::last_write_time(file_of(other, 5000), past);
  for (int i = 1; i <= 5; ++i) {
    must(cache.keep_rebuilt(session, state_at(static_cast<std::uint64_t>(i), 10'000)));
    fs::last_write_time(file_of(session, static_cast<std::uint64_t>(i)), past + std::chrono::hours(i == 3 ? 1 : 10 + i));
  }
  cache.limit(45'000);
  must(cache.keep_rebuilt(session, state_at(6, 10'000)));
  EXPECT_EQ(cache.ticks(session), (std::vector<std::uint64_t>{4, 5, 6})) << "3 is the oldest, then 1 and 2";
  EXPECT_EQ(cache.ticks(other), std::vector<std::uint64_t>{5000});
  cache.release(other);
  must(cache.keep_rebuilt(session, state_at(7, 10'000)));
  EXPECT_TRUE(cache.ticks(other).empty()) << "once graded, it is as old as it is";
  EXPECT_EQ(cache.ticks(session), (std::vector<std::uint64_t>{4, 5, 6, 7}));
}

TEST_F(KeyStatesTest, room_is_made_of_what_a_replay_can_bring_back_without_loss) {
  must(cache.keep_live(other, state_at(5000)));
  must(cache.keep_rebuilt(session, state_at(5000)));
  cache.make_room();
  EXPECT_TRUE(cache.ticks(session).empty());
  EXPECT_EQ(cache.ticks(other), std::vector<std::uint64_t>{5000});
}

TEST_F(KeyStatesTest, what_a_killed_writer_left_goes_with_the_sessions_next_state) {
  must(cache.keep_live(session, state_at(5000)));
  const fs::path left = cache.folder() / (session.text() + "-000000010000.live.Ab3dE6");
  std::ofstream(left) << "half";
  EXPECT_EQ(cache.ticks(session), std::vector<std::uint64_t>{5000});
  must(cache.keep_live(session, state_at(15'000)));
  EXPECT_FALSE(fs::exists(left));
  EXPECT_EQ(cache.ticks(session), (std::vector<std::uint64_t>{5000, 15'000}));
}

TEST_F(KeyStatesTest, where_no_folder_can_be_made_it_fails_and_reads_as_empty) {
  std::ofstream(cache.folder()) << "in the way";
  EXPECT_FALSE(cache.keep_live(session, state_at(5000)));
  EXPECT_FALSE(cache.keep_rebuilt(session, state_at(5000)));
  EXPECT_TRUE(cache.ticks(session).empty());
  EXPECT_FALSE(cache.read(session, 5000));
  cache.release(session);
  cache.make_room();
  cache.drop(session, 5000);
  EXPECT_EQ(fs::file_size(cache.folder()), 10u) << "what stands there is nobody's to remove";
}

}  // namespace
}  // namespace cusp::test
