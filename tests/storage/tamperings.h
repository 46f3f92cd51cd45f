/// Ways to tamper with a school by SQL, drawn with a seed.
#pragma once

#include <functional>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "tests/storage/school.h"

namespace cusp::test {

struct Tampering {
  std::string table, kind, column{};
  Uuid owner{};                         // what the finding has to name; nil = nothing in particular
  std::vector<std::string> named_as{};  // other tables under which it may be named
};

class Tamperer {
 public:
  /// nullopt if SQLite refuses it.
  using Act = std::function<std::optional<Tampering>(Database&)>;

  Tamperer(const School& school, unsigned seed) : school_{school}, random_{seed} {}
  /// Change, delete and insert for every table, then acts that need more than a row.
  std::vector<Act> acts();
  /// Makes school.trial() anew and tampers with it as a stranger would; the same act again until it succeeds.
  Tampering tamper(const Act& act);
  std::size_t draw(std::size_t below) { return random_() % below; }

 private:
  template <class T>
  const T& one_of(const std::vector<T>& some) {
    return some[draw(some.size())];
  }
  std::string one_row(Database& db, const std::string& table);
  std::optional<Tampering> change(Database& db, const std::string& table);
  std::optional<Tampering> remove(Database& db, const std::string& table);
  std::optional<Tampering> insert(Database& db, const std::string& table);
  void attach_old(Database& db) { must(db.run("ATTACH ?1 AS old", school_.old().string())); }
  Act on_account(std::string kind, std::string set, std::string where);
  enum class DatabaseFile : std::uint8_t { newest, older };
  Act on_counter(std::string kind, DatabaseFile file, std::function<void(const std::filesystem::path&)> act);
  std::vector<Act> session_acts();
  std::vector<Act> log_acts();
  std::vector<Act> forged_acts();
  std::vector<Act> account_acts();
  std::vector<Act> thinning_acts();
  std::vector<Act> counter_acts();

  const School& school_;
  std::mt19937 random_;
  std::function<void()> after_closing_;  // what is done to files
};

}  // namespace cusp::test
