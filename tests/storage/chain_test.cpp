#include "storage/records/chain.h"
#include "storage/records/station_key.h"

#include <gtest/gtest.h>

#include "storage/base/password.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

TEST(Hashes, blake2b_256_of_abc_is_that_of_other_implementations) {
  // python3: hashlib.blake2b(b"abc", digest_size=32).hexdigest()
  EXPECT_EQ(hex(blake2b_256(std::string_view{"abc"})),
            "bddd813c634239723171ef3fee98579b94964e3bb1cb3e427262c8c068d52319");
}

TEST(Hashes, neighbouring_fields_do_not_merge) {
  EXPECT_NE(Blake2b{}.add_text("ab").add_text("c").finish(), Blake2b{}.add_text("a").add_text("bc").finish());
}

TEST(Chain, every_part_of_an_entry_and_all_before_it_enter_the_link) {
  const Uuid session = Uuid::v7();
  const ChainLink entry{3, 2, 1, 7, blake2b_256(std::string_view{"row"})};
  const Hash256 link = chain_link(chain_start(session), session, entry);
  auto other = entry;
  other.position = 4;
  EXPECT_NE(chain_link(chain_start(session), session, other), link);
  other = entry;
  other.table = 3;
  EXPECT_NE(chain_link(chain_start(session), session, other), link);
  other = entry;
  other.row = 2;
  EXPECT_NE(chain_link(chain_start(session), session, other), link);
  other = entry;
  other.second = 8;
  EXPECT_NE(chain_link(chain_start(session), session, other), link);
  other = entry;
  other.content[31] ^= 1;
  EXPECT_NE(chain_link(chain_start(session), session, other), link);
  EXPECT_NE(chain_link(link, session, entry), link);
  EXPECT_NE(chain_start(Uuid::v7()), chain_start(session));
}

TEST(Heads, a_signature_holds_for_its_head_and_for_no_other) {
  const StationKey key = StationKey::make();
  const Uuid session = Uuid::v7();
  const Hash256 link = blake2b_256(std::string_view{"link"});
  const Signature signature = key.sign_head(session, {9, link});
  EXPECT_TRUE(head_signature_holds(key.public_key, session, {9, link}, signature));
  EXPECT_FALSE(head_signature_holds(key.public_key, session, {8, link}, signature));
  EXPECT_FALSE(head_signature_holds(key.public_key, Uuid::v7(), {9, link}, signature));
  EXPECT_FALSE(head_signature_holds(StationKey::make().public_key, session, {9, link}, signature));
  auto other = link;
  other[0] ^= 1;
  EXPECT_FALSE(head_signature_holds(key.public_key, session, {9, other}, signature));
}

TEST(Passwords, only_the_right_one_matches_and_equal_ones_are_stored_differently) {
  const auto cost = PasswordCost::least();
  const std::string stored = hash_password("correct horse", cost);
  EXPECT_TRUE(stored.starts_with("$argon2id$"));
  EXPECT_TRUE(password_matches(stored, "correct horse"));
  EXPECT_FALSE(password_matches(stored, "correct horsf"));
  EXPECT_FALSE(password_matches(stored, ""));
  EXPECT_FALSE(password_matches("", ""));
  EXPECT_FALSE(password_matches(std::string(500, 'x'), "correct horse"));
  EXPECT_NE(hash_password("correct horse", cost), stored);
}

TEST(Passwords, the_default_cost_is_libsodiums_interactive_one) {
  // libsodium 1.0.18, crypto_pwhash_argon2id.h: OPSLIMIT_INTERACTIVE 2, MEMLIMIT_INTERACTIVE 67108864
  EXPECT_EQ(PasswordCost::interactive().passes, 2u);
  EXPECT_EQ(PasswordCost::interactive().memory_bytes, 67108864u);
  const std::string stored = hash_password("correct horse", PasswordCost::interactive());
  EXPECT_TRUE(stored.starts_with("$argon2id$v=19$m=65536,t=2,p=1$")) << stored;
}

TEST(Passwords, a_pin_is_six_digits) {
  EXPECT_TRUE(acceptable_pin("031415"));
  for (const char* bad : {"", "12345", "1234567", "12345a", "12 456"}) EXPECT_FALSE(acceptable_pin(bad)) << bad;
}

}  // namespace
}  // namespace cusp::test
