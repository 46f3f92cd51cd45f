#include "ui/device/device_page.h"

#include <QApplication>
#include <QBoxLayout>
#include <QButtonGroup>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QRadioButton>
#include <QTimer>
#include <algorithm>
#include <optional>
#include <utility>

#include "device/falcon/permissions.h"
#include "device/hid/hid_station.h"
#include "ui/device/falcon_panel.h"
#include "ui/device/inverse_panel.h"
#include "ui/device/pedal_panel.h"
#include "ui/device/rights_row.h"
#include "ui/device/space_mouse_panel.h"
#include "ui/modules.h"
#include "ui/settings/device_settings.h"
#include "ui/text/falcon_text.h"
#include "ui/widgets/chip.h"
#include "ui/widgets/parts.h"

namespace cusp::ui {
namespace {

constexpr int kPageRefreshMs = 200;      // what was found is there already: no wait
constexpr int kShownDigits = 16;  // of the file's 64: enough to compare by eye

/// Tab follows reading: the rows, though they are made last, then what stands below them.
void rows_first(const QWidget& page, const QWidget& rows) {
  QWidget* before = nullptr;
  for (QRadioButton* pick : rows.findChildren<QRadioButton*>()) {
    if (before) QWidget::setTabOrder(before, pick);
    before = pick;
  }
  for (QWidget* below : page.findChildren<QWidget*>()) {
    const bool stop = (below->focusPolicy() & Qt::TabFocus) && !below->focusProxy() && below->window() == page.window();
    if (!stop || rows.isAncestorOf(below) || before == nullptr) continue;  // the list of a combo box has a window of its own
    QWidget::setTabOrder(before, below);
    before = below;
  }
}

enum class Seen { listed, missing, not_yet };

struct Standing {
  QString text{};  // empty: nothing is to be known
  Chip::Kind kind = Chip::Kind::plain;
};

Standing standing_of(const FoundDevice& device, Seen seen) {
  if (seen == Seen::not_yet) return {DevicePage::tr("looking"), Chip::Kind::plain};
  if (seen == Seen::missing) return {DevicePage::tr("not plugged in"), Chip::Kind::look};
  if (device.denied) return {DevicePage::tr("not permitted"), Chip::Kind::bad};
  if (device.kind == "falcon") return {DevicePage::tr("plugged in"), Chip::Kind::good};
  return {};
}

}  // namespace

struct DevicePage::Inner {
  Inner(const QString& file, Ports world, Role of, MakeWatch make)
      : device(file), ports(std::move(world)), role(of), make_watch(make ? std::move(make) : own_watch()) {
    begin_watch();
  }

  MakeWatch own_watch() {
    return [this] {
      return watch_in_background([service = device.inverse().service] { return watch_devices_at(service); });
    };
  }

  void begin_watch() {
    watched_port = device.inverse().service.port;
    watch = make_watch();
  }

  DeviceSettings device;
  Ports ports;
  Role role;
  bool staff() const { return role != Role::student; }
  MakeWatch make_watch;
  std::unique_ptr<DeviceWatch> watch;  // none while nobody sees the page
  std::uint16_t watched_port = 0;      // of the Inverse3's service
  bool known = false;                  // the first answer is there
  std::vector<FoundDevice> found;
  std::optional<FoundDevice> shown;    // the chosen one, as it was found when the Falcon's panel was set; nullopt: it was not
  QTimer timer;

  std::optional<FoundDevice> chosen_of_found() const {
    const DeviceChoice chosen = device.choice();
    const auto at = std::ranges::find_if(found, [&](const FoundDevice& one) { return one.kind == chosen.kind && one.name == chosen.name; });
    return at == found.end() ? std::nullopt : std::optional(*at);
  }

  QVBoxLayout* list;
  QButtonGroup* group = nullptr;
  QWidget* rows = nullptr;
  RightsRow* rights;
  QLabel *no_falcon, *firmware, *licence;
  Band* band;
  Card* firmware_card;
  FalconPanel* falcon;
  Card* inverse;
};

DevicePage::DevicePage(Settings& settings, Ports ports, Role role, hid::HidStation* hid, MakeWatch watch, QWidget* parent)
    : QWidget(parent), inner_(std::make_unique<Inner>(settings.file(), std::move(ports), role, std::move(watch))) {
  Inner& in = *inner_;
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(0, 0, 0, 0);
  QVBoxLayout* body = nullptr;
  outer->addWidget(make_scroll_page(&body));
  body->addWidget(new PageHead(tr("Device"), role != Role::student ? QString() : tr("Check it before you drill")));
  in.band = new Band(this);
  body->addWidget(in.band);

  auto* card = new Card(tr("What you drill with"), {}, this);
  in.list = new QVBoxLayout;
  in.list->setSpacing(px(4));
  card->body()->addLayout(in.list);
  in.no_falcon = make_label({}, TextRole::body, Weight::regular, "text2");
  in.no_falcon->setWordWrap(true);
  card->body()->addWidget(in.no_falcon);
  if (!in.staff()) card->body()->addWidget(make_label(tr("Staff choose the device."), TextRole::body, Weight::regular, "text2"));
  in.rights = new RightsRow(card);
  card->body()->addWidget(in.rights);
  body->addWidget(card);

  in.falcon = new FalconPanel(in.device, in.ports, role, this);
  connect(in.falcon, &FalconPanel::tested, this, &DevicePage::tested);
  body->addWidget(in.falcon);

  make_firmware_card();
  body->addWidget(in.firmware_card);

  in.inverse = new Card(QStringLiteral("Inverse3"), {}, this);
  auto* inverse = new InversePanel(&settings, make_inverse_port, in.inverse);
  if (!in.staff()) inverse->fix_settings();
  in.inverse->body()->addWidget(inverse);
  body->addWidget(in.inverse);
  if (hid) add_hid_cards(*hid, settings, body);
  body->addStretch();
  show_firmware();
  in.timer.setInterval(kPageRefreshMs);
  connect(&in.timer, &QTimer::timeout, this, &DevicePage::look);
  in.found = in.watch->list();
  in.known = in.watch->changed();
  fill();
  show_chosen();
}

void DevicePage::make_firmware_card() {
  Inner& in = *inner_;
  in.firmware_card = new Card(tr("Firmware of the Falcon"), {}, this);
  in.firmware = make_label({});
  in.firmware->setWordWrap(true);
  in.licence = make_label(tr("A Falcon forgets its firmware when its power is off. Cusp has none: the maker’s licence does not allow it. Name the "
                             "file that the maker’s software brought to this computer; that licence holds for its use."),
                          TextRole::caption, Weight::regular, "text2");
  in.licence->setWordWrap(true);
  in.firmware_card->body()->addWidget(in.firmware);
  in.firmware_card->body()->addWidget(in.licence);
  QPushButton* name = make_button(tr("Name the file…"), ButtonKind::standard, QStringLiteral("import"));
  connect(name, &QPushButton::clicked, this, &DevicePage::name_firmware);
  in.firmware_card->body()->addWidget(name, 0, Qt::AlignLeft);
  in.firmware_card->setVisible(in.staff());
}

void DevicePage::add_hid_cards(hid::HidStation& hid, Settings& settings, QVBoxLayout* body) {
  // The station keeps what staff set; Desktop::sign_out() takes a student's changes back.
  Settings* const kept = inner_->staff() ? &settings : nullptr;
  const QString aside = kept ? QString() : tr("Your changes last until you sign out");
  auto* pedal = new Card(tr("Foot pedal"), aside, this);
  pedal->body()->addWidget(new PedalPanel(hid.pedal(), kept, pedal));
  body->addWidget(pedal);
  auto* mouse = new Card(tr("SpaceMouse"), aside, this);
  mouse->body()->addWidget(new SpaceMousePanel(hid.space_mouse(), kept, mouse));
  body->addWidget(mouse);
}

DevicePage::~DevicePage() = default;

FalconPanel* DevicePage::falcon() const { return inner_->falcon; }

QStringList DevicePage::listed() const {
  QStringList out;
  for (const FoundDevice& one : inner_->found) out << device_title(one.kind, one.name);
  return out;
}

void DevicePage::showEvent(QShowEvent* event) {
  rows_first(*this, *inner_->rows);
  QWidget::showEvent(event);
  if (!inner_->watch) inner_->begin_watch();
  inner_->timer.start();
}

void DevicePage::hideEvent(QHideEvent* event) {
  inner_->timer.stop();
  inner_->watch.reset();
  QWidget::hideEvent(event);
}

void DevicePage::look() {
  Inner& in = *inner_;
  // A row that is made anew loses the press on it; a screen reader's lasts 100 ms.
  if (std::ranges::any_of(in.group->buttons(), &QAbstractButton::isDown)) return;
  if (in.watch && in.watched_port != in.device.inverse().service.port) in.begin_watch();
  if (!in.watch || !in.watch->changed()) return;
  auto now = in.watch->list();
  if (std::exchange(in.known, true) && now == in.found) return;
  in.found = std::move(now);
  fill();
}

void DevicePage::fill() {
  Inner& in = *inner_;
  const bool has_keys = in.rows != nullptr && in.rows->isAncestorOf(QApplication::focusWidget());
  delete in.rows;
  in.rows = new QWidget(this);
  auto* column = new QVBoxLayout(in.rows);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(px(4));
  in.group = new QButtonGroup(in.rows);
  const DeviceChoice chosen = in.device.choice();
  const auto is_chosen = [&chosen](const FoundDevice& one) { return one.kind == chosen.kind && one.name == chosen.name; };
  const bool there = std::any_of(in.found.begin(), in.found.end(), is_chosen);
  auto rows = in.found;
  if (!there) rows.insert(rows.begin(), FoundDevice{chosen.kind, chosen.name, {}, false});
  bool denied = false;
  for (const FoundDevice& one : rows) {
    auto* line = new QHBoxLayout;
    line->setSpacing(px(12));
    auto* pick = new QRadioButton(device_title(one.kind, one.name));
    pick->setAccessibleName(pick->text());
    pick->setChecked(is_chosen(one));
    pick->setEnabled(in.staff() || is_chosen(one));
    in.group->addButton(pick);
    // However it is set down: a screen reader does it without a click.
    connect(pick, &QRadioButton::toggled, this, [this, one](bool on) {
      if (on) use(one);
    });
    line->addWidget(pick);
    denied = denied || one.denied;
    const Standing standing = standing_of(one, there || !is_chosen(one) ? Seen::listed : in.known ? Seen::missing : Seen::not_yet);
    if (!standing.text.isEmpty()) line->addWidget(new Chip(standing.text, standing.kind));
    const QString socket = one.port.empty() ? QString() : tr("Socket %1").arg(QString::fromStdString(one.port));
    if (!socket.isEmpty()) line->addWidget(make_label(socket, TextRole::caption, Weight::regular, "text2"));
    QStringList beside{standing.text, socket};
    beside.removeAll(QString());
    pick->setAccessibleDescription(beside.join(u", "_qs));  // a screen reader stands on the button alone
    line->addStretch();
    column->addLayout(line);
  }
  in.list->addWidget(in.rows);
  if (has_keys && in.group->checkedButton() != nullptr) {
    in.rows->show();
    in.group->checkedButton()->setFocus(Qt::OtherFocusReason);
  }
  if (isVisible()) rows_first(*this, *in.rows);  // before, its parts stand in no window
  in.no_falcon->setText(in.known ? tr("No Falcon is plugged in. One that is plugged in appears here by itself.")
                                 : tr("Looking at what is plugged in."));
  in.no_falcon->setVisible(std::none_of(in.found.begin(), in.found.end(), [](const auto& one) { return one.kind == "falcon"; }));
  // Staff name the port of a service that is not found.
  in.inverse->setVisible(in.staff() || chosen.kind == "inverse3" ||
                         std::any_of(in.found.begin(), in.found.end(), [](const auto& one) { return one.kind == "inverse3"; }));
  in.rights->set_command(denied ? QString::fromStdString(falcon::udev_install_command()) : QString());
  // What else comes or goes ends no test of the chosen one.
  if (in.chosen_of_found() != in.shown) show_chosen();
}

void DevicePage::use(const FoundDevice& device) {
  Inner& in = *inner_;
  in.band->clear();  // it speaks of the choice before
  if (!in.device.choose(device.kind, device.name)) {
    in.band->show_message(Band::Kind::bad, tr("The device holds until Cusp is closed."),
                          tr("%1 cannot be written, so the next start does not know the device.").arg(in.device.file()));
  }
  show_chosen();
  Q_EMIT chosen();
}

void DevicePage::show_chosen() {
  Inner& in = *inner_;
  const DeviceChoice chosen = in.device.choice();
  in.shown = in.chosen_of_found();
  const bool falcon = chosen.kind == "falcon" || chosen.kind == "emulated-falcon";
  in.falcon->setVisible(falcon);
  if (falcon) {
    in.falcon->set_device(chosen.kind, chosen.name);
  } else {
    in.falcon->release();
  }
}

void DevicePage::show_firmware() {
  const FirmwareChoice firmware = inner_->device.firmware();
  if (firmware.file.empty()) {
    inner_->firmware->setText(tr("No file is named."));
    return;
  }
  inner_->firmware->setText(tr("%1, SHA-256 %2…").arg(QString::fromStdString(firmware.file.string()),
                                                      QString::fromStdString(firmware.sha256).left(kShownDigits)));
  inner_->firmware->setToolTip(QString::fromStdString(firmware.sha256));
}

void DevicePage::name_firmware() {
  inner_->ports.pick_file(this, {tr("Firmware of the Falcon"), {}, tr("Firmware (*.bin *.BIN)"), false},
                          [self = QPointer(this)](const QString& path) {
                            if (!self) return;
                            Inner& in = *self->inner_;
                            const auto image = falcon::FirmwareImage::from_file(path.toStdString());
                            if (!image) {
                              const Message message = describe_image(image.error());
                              in.band->show_message(Band::Kind::bad, message.what, message.more);
                              return;
                            }
                            if (in.device.set_firmware({path.toStdString(), image->sha256()})) {
                              in.band->show_message(Band::Kind::good, tr("The file is sound and will be used."));
                            } else {
                              in.band->show_message(Band::Kind::bad, tr("The file is sound and will be used until Cusp is closed."),
                                                    tr("%1 cannot be written, so the next start does not know the file.").arg(in.device.file()));
                            }
                            self->show_firmware();
                            self->show_chosen();
                          });
}

}  // namespace cusp::ui
