// A computer whose clock shows an older date than the records: staff read that before anybody drills.
#include <gtest/gtest.h>

#include <QTemporaryDir>

#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "ui/app/desktop.h"
#include "ui/app/shell.h"
#include "ui/signin/sign_in.h"
#include "ui/widgets/parts.h"

namespace cusp::test {
namespace {

struct ClockBehindDesk : testing::Test {
  ClockBehindDesk() { records.attempt(records.student("1", "Lena Brandt"), "channel-1", 78, 60); }
  /// What the sign-in's staff and then the administrator read where the records' clock shows this.
  QStringList bands_at(std::int64_t utc_us) {
    Desktop desktop(settings, Ports::of_the_system(), records.file(), [utc_us](const std::filesystem::path& file, const StoreOptions& options) {
      StoreOptions with_clock = options;
      with_clock.clock = [utc_us] { return utc_us; };
      return Store::open(file, with_clock);
    });
    desktop.start();
    desktop.show();
    qobject_cast<SignIn*>(desktop.page())->set_typed_number({}, SignIn::Who::staff);
    QStringList out{shown(*desktop.page())};
    desktop.sign_in(records.administrator());
    return out << shown(*desktop.shell());
  }
  static QString shown(const QWidget& page) {
    QString text;
    for (const Band* band : page.findChildren<Band*>())
      if (!band->isHidden()) text += band->text();
    return text;
  }

  DeskRecords records;
  const QTemporaryDir folder;
  Settings settings{folder.filePath(QStringLiteral("Cusp.ini"))};
};

TEST_F(ClockBehindDesk, is_shown_to_staff_at_sign_in_and_to_administrators) {
  for (const QString& bands : bands_at(kMorning + 3'600'000'000)) EXPECT_FALSE(bands.contains(QStringLiteral("clock is behind"))) << bands.toStdString();
  for (const QString& bands : bands_at(kMorning - 400 * std::int64_t{86'400'000'000}))
    EXPECT_TRUE(bands.contains(QStringLiteral("This computer’s clock is behind."))) << bands.toStdString();
}

}  // namespace
}  // namespace cusp::test
