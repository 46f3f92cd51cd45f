/// An office and a station, each with an administrator, and the files that the station gives out.
#pragma once

#include <string>

#include "storage/exchange/exchange.h"
#include "storage/exchange/trust.h"
#include "tests/storage/shared_records.h"

namespace cusp::test {

struct TwoStations : ::testing::Test {
  Folder folder;
  std::unique_ptr<Store> office = open(folder / "office.db"), station = open(folder / "station.db");
  Actor chief = make_administrator(*office, "admin").actor(), keeper = make_administrator(*station, "keeper").actor();
  int files = 0;

  static Account make_administrator(Store& store, const std::string& number) {
    return must(store.accounts.create_first_administrator(
        {.number = number, .name = "Maya Okafor", .role = Role::administrator, .password = "correct horse"}));
  }
  static PublicKey key_of_station(Store& store) {
    return must(public_key_from(must(own_key(store.context(), {UserId::make(), Role::administrator}))));
  }
  void trust_each_other() {
    must(trust(office->context(), chief, key_of_station(*station), KeyRole::station));
    must(trust(station->context(), keeper, key_of_station(*office), KeyRole::office));
  }
  std::filesystem::path next_file() { return folder / ("file-" + std::to_string(++files)); }
  std::filesystem::path results() {
    const std::filesystem::path file = next_file();
    must(give_out(station->context(), keeper, ExchangeKind::results, file));
    return file;
  }
  std::filesystem::path office_file() {
    const std::filesystem::path file = next_file();
    must(give_out(office->context(), chief, ExchangeKind::office, file));
    return file;
  }
  /// Reads a file in there.
  ReadIn at_office(const std::filesystem::path& file) { return must(read_in(office->context(), chief, file)); }
  ReadIn at_station(const std::filesystem::path& file) { return must(read_in(station->context(), keeper, file)); }
  SessionId attempt(const Account& student, double score = 81.5) { return complete_session(*station, student, keep(*station), score); }
  /// What verification finds; empty if all is whole.
  static std::string whole(Store& store) {
    std::string out;
    for (const ChainFinding& f : must(verify_store(store.context())).findings) out += std::string(key_of(f.code)) + ' ' + f.table + ' ' + f.what + '\n';
    return out;
  }
};

}  // namespace cusp::test
