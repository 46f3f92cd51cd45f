// A desktop over records of its own. The test answers what it asks.
#pragma once

#include <gtest/gtest.h>

#include <QStringList>
#include <QTemporaryDir>
#include <functional>
#include <memory>

#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "ui/app/desktop.h"

namespace cusp::test {

struct AskingDesktop : testing::Test {
  AskingDesktop() {
    ports.ask = [this](QWidget*, const Question& question, std::function<void(bool)> then) {
      asked += question.what;
      more = question.more;
      answer = std::move(then);
    };
  }
  /// Before start().
  void show() {
    desktop = std::make_unique<Desktop>(settings, ports, records.file());
    desktop->show();
  }
  void sign_in(const Account& who) {
    show();
    desktop->start();
    desktop->sign_in(who);
  }
  /// Makes the account; once.
  Account instructor() {
    return *records.store().accounts.create(records.administrator().actor(), {"berg", "Dr Berg", Role::instructor, "correct horse", ""});
  }

  DeskRecords records;
  QTemporaryDir folder;
  Settings settings{folder.filePath(QStringLiteral("Cusp.ini"))};
  Ports ports = Ports::of_the_system();
  QStringList asked;
  QString more;  // of the last question
  std::function<void(bool)> answer;
  std::unique_ptr<Desktop> desktop;
};

}  // namespace cusp::test
