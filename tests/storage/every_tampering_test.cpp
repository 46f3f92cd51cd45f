/// A small school, tampered with by SQL in every table and every way that comes to mind, drawn with a seed: each
/// tampering is found and named, by reading alone and again after the program has written to the file, or it stands in
/// harmless.cpp with the reason. CUSP_TAMPER_SEED=N draws others.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>

#include "tests/storage/harmless.h"
#include "tests/storage/tamperings.h"

namespace cusp::test {
namespace {


constexpr int kTamperings = 200;

struct Count {
  int found = 0, harmless = 0, missed = 0;
};
using Counts = std::map<std::pair<std::string, std::string>, Count>;  // by table and kind

void print(const Counts& counts) {
  std::printf("%-18s %-28s %6s %9s %7s\n", "table", "kind", "found", "harmless", "missed");
  for (const auto& [key, c] : counts) {
    std::printf("%-18s %-28s %6d %9d %7d\n", key.first.c_str(), key.second.c_str(), c.found, c.harmless, c.missed);
  }
}

class EveryTamperingTest : public ::testing::Test {
 protected:
  static unsigned seed() {
    const char* given = std::getenv("CUSP_TAMPER_SEED");
    return given ? static_cast<unsigned>(std::atoi(given)) : 20261121;
  }
  static bool named(const StoreVerification& v, const Tampering& t) {
    for (const ChainFinding& f : v.findings) {
      const bool table = f.table == t.table || std::ranges::find(t.named_as, f.table) != t.named_as.end();
      if (table && (t.owner.is_nil() || f.owner == t.owner)) return true;
    }
    return false;
  }
  static std::string text_of(const StoreVerification& v) {
    std::string out;
    for (const ChainFinding& f : v.findings) {
      out += "\n  " + std::string(key_of(f.code)) + " " + f.table + " " + std::to_string(f.row) + " " +
             (f.owner.is_nil() ? "" : f.owner.text()) + " " + f.what;
    }
    return out;
  }
  static const Harmless* harmless(const Tampering& t) {
    for (const Harmless& h : harmless_tamperings()) {
      if (h.table == t.table && h.kind == t.kind && (h.column.empty() || h.column == t.column)) return &h;
    }
    return nullptr;
  }

  School school_;
};

TEST_F(EveryTamperingTest, is_found_and_named_or_listed_as_harmless) {
  Tamperer tamperer(school_, seed());
  const auto acts = tamperer.acts();

  Counts counts;
  int found = 0;
  for (int i = 0; i < kTamperings; ++i) {
    // Every act once, then as drawn.
    const auto at = static_cast<std::size_t>(i);
    const Tampering t = tamperer.tamper(at < acts.size() ? acts[at] : acts[tamperer.draw(acts.size())]);
    const std::string what =
        std::to_string(i) + ": " + t.table + " " + t.kind + " " + t.column + " seed " + std::to_string(seed());
    StoreOptions reading = quick();
    reading.database.access = DatabaseOptions::Access::read_only;
    const auto read = must(verify_store(open(school_.trial(), reading)->context()));
    // And as the program meets it: opened for writing, somebody signs in, then the proof.
    const auto store = open(school_.trial());
    static_cast<void>(store->accounts.sign_in("admin", "correct horse"));
    const auto written = must(verify_store(store->context()));
    Count& count = counts[{t.table, t.kind}];
    const bool good = named(read, t) && named(written, t);
    if (good) {
      ++count.found;
      ++found;
    } else if (harmless(t) != nullptr) {
      ++count.harmless;
    } else {
      ++count.missed;
      ADD_FAILURE() << what << "\nread:" << text_of(read) << "\nafter writing:" << text_of(written);
    }
  }
  print(counts);
  std::printf("%d of %d found and named, seed %u\n", found, kTamperings, seed());
  RecordProperty("seed", static_cast<int>(seed()));
  RecordProperty("found", found);
}

TEST_F(EveryTamperingTest, a_school_that_nobody_touched_is_whole) {
  StoreOptions reading = quick();
  reading.database.access = DatabaseOptions::Access::read_only;
  for (const bool to_read : {true, false, true}) {
    const auto store = open(school_.now(), to_read ? reading : quick());
    const auto proof = must(verify_store(store->context()));
    EXPECT_TRUE(proof.intact()) << text_of(proof);
    EXPECT_EQ(proof.sessions, school_.sessions.size() + 1) << "and one of another station";
    EXPECT_EQ(proof.sealed_later, 0u);
    EXPECT_EQ(proof.uncounted, 0u);
    EXPECT_FALSE(store->context().incident);
  }
}

}  // namespace
}  // namespace cusp::test
