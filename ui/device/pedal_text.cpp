#include "ui/device/pedal_text.h"

#include <QCoreApplication>

#include "ui/widgets/format.h"

namespace cusp::ui {

namespace {

struct PedalText {
  Q_DECLARE_TR_FUNCTIONS(cusp::ui::PedalText)
};

/// Names that are the same in every language where keyboards have them.
QString key_name(std::uint16_t usage) {
  if (usage >= 0x04 && usage <= 0x1D) return QString(QChar(static_cast<char16_t>(u'A' + usage - 0x04)));
  if (usage >= 0x1E && usage <= 0x26) return QString::number(usage - 0x1D);
  if (usage == 0x27) return QStringLiteral("0");
  if (usage >= 0x3A && usage <= 0x45) return QStringLiteral("F%1").arg(usage - 0x39);
  if (usage >= 0x68 && usage <= 0x73) return QStringLiteral("F%1").arg(usage - 0x68 + 13);
  if (usage == 0x2C) return PedalText::tr("space bar");
  return QString::number(usage);
}

QString axis_name(hid::ControlId id) {
  if (id.page == hid::usage::kSimulationPage) {
    switch (id.usage) {
      case 0xBA: return PedalText::tr("Rudder");
      case 0xBB: return PedalText::tr("Throttle");
      case 0xC4: return PedalText::tr("Accelerator");
      case 0xC5: return PedalText::tr("Brake");
      case 0xC6: return PedalText::tr("Clutch");
      default: break;
    }
  }
  static const char* const kNames[] = {"X", "Y", "Z", "Rx", "Ry", "Rz"};
  if (id.page == hid::usage::kDesktopPage && id.usage >= 0x30 && id.usage <= 0x35)
    return PedalText::tr("Axis %1").arg(QLatin1String(kNames[id.usage - 0x30]));
  return PedalText::tr("Axis %1").arg(QString::number(id.usage, 16).toUpper());
}

}  // namespace

QString control_name(hid::ControlId id, hid::ControlKind kind) {
  QString name;
  switch (kind) {
    case hid::ControlKind::button: name = PedalText::tr("Switch %1").arg(id.usage); break;
    case hid::ControlKind::key: name = PedalText::tr("Key %1").arg(key_name(id.usage)); break;
    case hid::ControlKind::axis: name = axis_name(id); break;
  }
  return id.index == 0 ? name : QStringLiteral("%1 (%2)").arg(name).arg(id.index + 1);
}

QString control_name(const hid::Control& control) { return control_name(control.id, control.kind); }

hid::ControlKind control_kind(hid::ControlId id, const std::vector<hid::Control>& controls) {
  for (const hid::Control& control : controls) {
    if (control.id == id) return control.kind;
  }
  return id.page == hid::usage::kKeyPage      ? hid::ControlKind::key
         : id.page == hid::usage::kButtonPage ? hid::ControlKind::button
                                              : hid::ControlKind::axis;
}

QString hid_name(const hid::HidDevice& device) {
  const QString name = QString::fromStdString(device.name).trimmed();
  if (!name.isEmpty()) return isolate(name);
  return isolate(QStringLiteral("%1:%2")
                     .arg(device.vendor, 4, 16, QLatin1Char('0'))
                     .arg(device.product, 4, 16, QLatin1Char('0')));
}

}  // namespace cusp::ui
