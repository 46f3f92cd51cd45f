#include "ui/settings/settings.h"

#include <QDir>
#include <QStandardPaths>
#include <algorithm>

#include "ui/settings/write_settings.h"

namespace cusp::ui {
namespace {

/// What is no number counts as missing: 0 minutes would never sign out.
int whole_number(const QSettings& store, const QString& key, int usual) {
  bool ok = false;
  const int value = store.value(key, usual).toInt(&ok);
  return ok ? value : usual;
}

}  // namespace

QString Settings::usual_file() {
  return QStandardPaths::writableLocation(QStandardPaths::GenericConfigLocation) + QStringLiteral("/Cusp/Cusp.ini");
}

Settings::Settings(const QString& file) : store_(file.isEmpty() ? usual_file() : file, QSettings::IniFormat) {}

void Settings::read_again() { store_.sync(); }

ColourScheme Settings::scheme() const {
  const QString text = store_.value("look/theme").toString();
  return text == u"light" ? ColourScheme::light : text == u"dark" ? ColourScheme::dark : ColourScheme::system;
}
void Settings::set_scheme(ColourScheme scheme) {
  store_.setValue("look/theme", scheme == ColourScheme::light  ? u"light"_qs
                                : scheme == ColourScheme::dark ? u"dark"_qs
                                                               : u"system"_qs);
}
QString Settings::language() const { return store_.value("look/language").toString(); }
void Settings::set_language(const QString& code) { store_.setValue("look/language", code); }
QString Settings::exercise_language() const { return store_.value("look/exercise_language").toString(); }
void Settings::set_exercise_language(const QString& code) { store_.setValue("look/exercise_language", code); }
int Settings::scale_percent() const { return std::clamp(whole_number(store_, u"look/scale"_qs, 100), 100, 200); }
void Settings::set_scale_percent(int percent) { store_.setValue("look/scale", std::clamp(percent, 100, 200)); }
int Settings::volume_percent() const {
  return std::clamp(whole_number(store_, u"sound/volume"_qs, kUsualVolumePercent), 0, 100);
}
void Settings::set_volume_percent(int percent) { store_.setValue("sound/volume", std::clamp(percent, 0, 100)); }
bool Settings::muted() const { return store_.value("sound/muted", false).toBool(); }
void Settings::set_muted(bool muted) { store_.setValue("sound/muted", muted); }
bool Settings::handpiece_shown() const { return store_.value("view/handpiece", true).toBool(); }
void Settings::set_handpiece_shown(bool shown) { store_.setValue("view/handpiece", shown); }
bool Settings::left_handed() const { return store_.value("view/left_handed", false).toBool(); }
void Settings::set_left_handed(bool left) { store_.setValue("view/left_handed", left); }
int Settings::idle_minutes() const {
  return std::clamp(whole_number(store_, u"station/idle_minutes"_qs, kUsualIdleMinutes), 0, kMostIdleMinutes);
}
bool Settings::set_idle_minutes(int minutes) { return keep(u"station/idle_minutes"_qs, std::clamp(minutes, 0, kMostIdleMinutes)); }
std::filesystem::path Settings::backup_folder(const std::filesystem::path& database) const {
  const QString chosen = store_.value("records/backup_folder").toString();
  return chosen.isEmpty() ? database.parent_path() / "backups" : std::filesystem::path(chosen.toStdString());
}
bool Settings::set_backup_folder(const QString& folder) { return keep(u"records/backup_folder"_qs, folder); }
QString Settings::station_name(const QString& station) const { return store_.value("stations/" + station).toString(); }
bool Settings::set_station_name(const QString& station, const QString& name) { return keep("stations/" + station, name.trimmed()); }
bool Settings::keep(const QString& key, const QVariant& value) { return write_settings(file(), {{key, value}}); }
QByteArray Settings::window() const { return store_.value("window/geometry").toByteArray(); }
void Settings::set_window(const QByteArray& geometry) { store_.setValue("window/geometry", geometry); }

std::filesystem::path database_path(const QString& option) {
  if (!option.isEmpty()) return option.toStdString();
  const QString from_environment = qEnvironmentVariable("CUSP_DB");
  if (!from_environment.isEmpty()) return from_environment.toStdString();
  const QString folder =
      QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) + QStringLiteral("/Cusp");
  QDir().mkpath(folder);
  return (folder + QStringLiteral("/cusp.db")).toStdString();
}

}  // namespace cusp::ui
