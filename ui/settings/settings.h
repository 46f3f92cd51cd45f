/// What the desktop remembers about how it is shown. Nothing about people or results: that is storage's.
/// File: XDG config folder, Cusp/Cusp.ini. GUI thread.
#pragma once

#include <QByteArray>
#include <QSettings>
#include <QString>
#include <filesystem>

#include "ui/widgets/theme.h"

namespace cusp::ui {

class Settings {
 public:
  /// `file` empty: the user's own.
  explicit Settings(const QString& file = {});
  static QString usual_file();
  QString file() const { return store_.fileName(); }
  /// Takes what another window of Cusp has written since: without it a setting is that of the start.
  void read_again();

  ColourScheme scheme() const;
  void set_scheme(ColourScheme scheme);
  /// "" = the system's language.
  QString language() const;
  void set_language(const QString& code);
  /// Of the exercises' own texts; "" = as the program.
  QString exercise_language() const;
  void set_exercise_language(const QString& code);
  /// 100 to 200.
  int scale_percent() const;
  void set_scale_percent(int percent);
  /// Of the drilling sound, 0 to 100; muted or not.
  int volume_percent() const;
  void set_volume_percent(int percent);
  bool muted() const;
  void set_muted(bool muted);
  static constexpr int kUsualVolumePercent = 50;
  /// Whether the handpiece is drawn above the bur; it is unless somebody put it away.
  bool handpiece_shown() const;
  void set_handpiece_shown(bool shown);
  /// Whether the left hand holds the handpiece.
  bool left_handed() const;
  void set_left_handed(bool left);
  /// Minutes without input after which the desktop signs out; 0 = never.
  int idle_minutes() const;
  /// False: as of set_backup_folder().
  bool set_idle_minutes(int minutes);
  static constexpr int kUsualIdleMinutes = 15, kMostIdleMinutes = 240;
  /// Where the daily backups of a database go; "backups" beside it unless another folder was chosen.
  std::filesystem::path backup_folder(const std::filesystem::path& database) const;
  /// False: the file cannot be written, and the choice ends with the program.
  bool set_backup_folder(const QString& folder);
  /// What people here call a station, this one too. Empty: nothing yet. `station`: its id.
  QString station_name(const QString& station) const;
  /// False: as of set_backup_folder().
  bool set_station_name(const QString& station, const QString& name);
  QByteArray window() const;
  void set_window(const QByteArray& geometry);

 private:
  /// Writes the file at once. False: it cannot be written.
  bool keep(const QString& key, const QVariant& value);

  QSettings store_;
};

/// Where this station's records lie: --db or CUSP_DB, else the XDG data folder's Cusp/cusp.db.
std::filesystem::path database_path(const QString& option);

}  // namespace cusp::ui
