/// A station for tests of the page for files between stations.
#pragma once

#include <QTemporaryDir>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "storage/exchange/trust.h"
#include "storage/store.h"
#include "tests/modules.h"
#include "ui/settings/settings.h"

namespace cusp::test {

/// A station with an administrator of its own and a page of it.
struct OneStation {
  explicit OneStation(const std::string& number) {
    StoreOptions options;
    options.cost = PasswordCost::least();
    store = std::move(*Store::open((folder.path() + QStringLiteral("/cusp.db")).toStdString(), options));
    admin = *store->accounts.create_first_administrator(
        {.number = number, .name = "Keeper " + number, .role = Role::administrator, .password = "correct horse", .pin = {}});
  }
  Account student(const std::string& number, const std::string& name) {
    return *store->accounts.create(admin.actor(), {.number = number, .name = name, .role = Role::student, .password = {}, .pin = "314159"});
  }
  Hash256 key() { return store->context().key->id(); }
  PublicKey public_key() { return *public_key_from(*own_key(store->context(), admin.actor())); }
  std::vector<OtherKey> known() { return *other_keys(store->context(), admin.actor()); }
  std::size_t people() { return store->accounts.list(admin.actor())->size(); }

  QTemporaryDir folder;
  std::unique_ptr<Store> store;
  Account admin;
  Settings settings{folder.filePath(QStringLiteral("Cusp.ini"))};
};

}  // namespace cusp::test
