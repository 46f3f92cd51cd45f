#include "ui/app/sentences.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QFileInfo>
#include <QLocale>
#include <cmath>
#include <map>

#include "scenarios/teeth/own_tissues.h"
#include "ui/app/language.h"
#include "ui/widgets/format.h"

namespace cusp {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(cusp::Sentences)
};

QString text(const std::string& s) { return QString::fromStdString(s); }

/// "/target/depth_mm" or "scenario.json#/target/depth_mm" as it stands; a path is shown whole.
QString place(const std::string& where) { return isolate(text(where)); }

}  // namespace

QString local(const LocalText& texts) {
  const std::string code = current_language().toStdString();
  if (const auto it = texts.find(code); it != texts.end()) return text(it->second);
  if (const auto it = texts.find("en"); it != texts.end()) return text(it->second);
  return texts.empty() ? QString() : text(texts.begin()->second);
}

Told tell(const StorageFailure& f) {
  const QString where = place(f.where);
  switch (f.code) {
    case StorageError::not_found:
      if (f.detail == "folder") {
        return {Words::tr("The database’s folder is not there."),
                Words::tr("There is no folder %1. Make it, or choose another place with --db.").arg(where)};
      }
      return {Words::tr("The record is not there."), Words::tr("%1 was not found. Nothing was changed.").arg(where)};
    case StorageError::not_a_database:
      return {Words::tr("This file is not a Cusp database."),
              Words::tr("%1 was left as it is. Choose another file with --db.").arg(where)};
    case StorageError::newer_schema:
      return {Words::tr("This database was written by a newer version of Cusp."),
              Words::tr("%1 was left as it is. Install the newer version to open it.").arg(where)};
    case StorageError::network_drive:
      return {Words::tr("The database lies on a network drive."),
              Words::tr("%1 would not be safe there. Move it to this computer’s own disk.").arg(where)};
    case StorageError::read_only:
      if (f.detail == "new file") {
        return {Words::tr("The database cannot be made there."),
                Words::tr("No file can be made at %1. Choose another place with --db.").arg(where)};
      }
      return {Words::tr("The database cannot be written."),
              Words::tr("%1 or its folder is read-only. Nothing was changed.").arg(where)};
    case StorageError::disk_full:
      return {Words::tr("The disk is full."),
              Words::tr("Nothing of the last step was written to %1; all before it is kept. Free some space and try "
                        "again.")
                  .arg(where)};
    case StorageError::io:
      return {Words::tr("The disk failed."),
              Words::tr("Nothing of the last step was written to %1; all before it is kept.").arg(where)};
    case StorageError::busy:
      return {Words::tr("Another program holds the database."),
              Words::tr("%1 stayed as it was. Close the other program and try again.").arg(where)};
    case StorageError::corrupt:
      return {Words::tr("The database is damaged."),
              Words::tr("%1 cannot be read whole. Nothing was changed; restore it from a backup.").arg(where)};
    case StorageError::wrong_password:
      return {Words::tr("Number and password do not match."), Words::tr("Check both and try again.")};
    case StorageError::locked: {
      const qint64 until_us = QString::fromStdString(f.detail).toLongLong();
      if (until_us <= 0) return {Words::tr("Too many wrong tries."), Words::tr("Wait a little and try again.")};
      const QDateTime until = QDateTime::fromMSecsSinceEpoch(until_us / 1000).toLocalTime();
      return {Words::tr("Too many wrong tries."),
              Words::tr("Signing in is open again at %1.").arg(QLocale().toString(until.time(), u"HH:mm:ss"_qs))};
    }
    case StorageError::disabled:
      return {Words::tr("This account is switched off."), Words::tr("Ask an administrator to switch it on again.")};
    case StorageError::not_allowed:
      return {Words::tr("Your role may not do this."), Words::tr("Nothing was changed.")};
    case StorageError::weak_password:
      return {Words::tr("This password is too short."),
              Words::tr("A password has at least 8 characters, a PIN exactly six digits. Nothing was changed.")};
    case StorageError::last_administrator:
      return {Words::tr("This is the last administrator."),
              Words::tr("Somebody has to manage people. Make another administrator first.")};
    case StorageError::duplicate:
      return {Words::tr("This is there already."), Words::tr("%1 is taken. Nothing was changed.").arg(where)};
    case StorageError::bad_value:
      return {Words::tr("A value is missing or outside its range."),
              Words::tr("Look at %1. Nothing was changed.").arg(where)};
    case StorageError::wrong_state:
      return {Words::tr("This go is not in a state that allows it."), Words::tr("Nothing was changed.")};
    case StorageError::bad_trace:
      return {Words::tr("The recording cannot be read."),
              Words::tr("%1 is damaged; the grade and all other goes are kept.").arg(where)};
  }
  return {Words::tr("The database failed."), where};
}

Told tell(const FormatFailure& f) {
  const QString where = place(f.where), detail = text(f.detail);
  const QString kept = Words::tr("Nothing was changed.");
  const QString what = Words::tr("This exercise cannot be read.");
  const auto at = [&](const QString& why) { return Told{what, why + u' ' + kept}; };
  switch (f.code) {
    case FormatError::unreadable: return at(Words::tr("The file %1 cannot be opened.").arg(where));
    case FormatError::too_large: return at(Words::tr("%1 is larger than any exercise.").arg(where));
    case FormatError::broken_json: return at(Words::tr("The text breaks off or is malformed at %1.").arg(where));
    case FormatError::duplicate_key: return at(Words::tr("%1 stands there twice.").arg(where));
    case FormatError::newer_format:
      return at(Words::tr("%1 was written by a newer version of Cusp (format %2).").arg(where, detail));
    case FormatError::unknown_key: return at(Words::tr("%1 is not known.").arg(where));
    case FormatError::missing_key: return at(Words::tr("%1 is missing.").arg(where));
    case FormatError::wrong_type: return at(Words::tr("%1 has to be: %2.").arg(where, detail));
    case FormatError::out_of_range: return at(Words::tr("%1 has to lie in %2.").arg(where, detail));
    case FormatError::not_finite: return at(Words::tr("%1 is not a number.").arg(where));
    case FormatError::bad_id: return at(Words::tr("%1 is not an identity.").arg(where));
    case FormatError::bad_language: return at(Words::tr("%1 names no language, or English is missing.").arg(where));
    case FormatError::bad_file_name: return at(Words::tr("%1 leads out of the exercise’s folder.").arg(where));
    case FormatError::duplicate_value: return at(Words::tr("%1 is named twice.").arg(where));
    case FormatError::unknown_tissue:
    case FormatError::unknown_metric:
    case FormatError::unknown_critical:
    case FormatError::unknown_method:
    case FormatError::unknown_generator:
    case FormatError::unknown_shape:
    case FormatError::unknown_phenomenon:
    case FormatError::unknown_burr:
      return at(detail.isEmpty() ? Words::tr("%1 names something that is not known.").arg(where)
                                 : Words::tr("%1 names something that is not known: %2.").arg(where, detail));
    case FormatError::unknown_builtin: return at(Words::tr("No exercise called %1 comes with the program.").arg(where));
  }
  return at(where);
}

Told tell(const ImportFailure& f) {
  const QString where = place(f.where), detail = text(f.detail);
  const QString kept = Words::tr("Nothing was changed.");
  const QString what = Words::tr("This file cannot be read.");
  const auto at = [&](const QString& why) { return Told{what, why + u' ' + kept}; };
  switch (f.code) {
    case ImportError::missing_file: return at(Words::tr("There is no file %1.").arg(where));
    case ImportError::io:
      return {Words::tr("This file cannot be read or written."),
              detail.isEmpty() ? where + u' ' + kept : Words::tr("%1: %2.").arg(where, detail) + u' ' + kept};
    case ImportError::unknown_format: return at(Words::tr("%1 is of a kind that is not read here.").arg(where));
    case ImportError::bad_header: return at(Words::tr("Its head is wrong at %1.").arg(where));
    case ImportError::unsupported: return at(Words::tr("It uses %1, which is not read here.").arg(where));
    case ImportError::bad_sizes: return at(Words::tr("The sizes at %1 make no volume.").arg(where));
    case ImportError::bad_spacing: return at(Words::tr("At %1 its cells are not evenly spaced.").arg(where));
    case ImportError::bad_orientation: return at(Words::tr("The axes at %1 are oblique or not known.").arg(where));
    case ImportError::bad_tissue: return at(Words::tr("%1 names no tissue.").arg(where));
    case ImportError::truncated: return at(Words::tr("%1 ends too early. Copy it again.").arg(where));
    case ImportError::corrupt: return at(Words::tr("%1 is damaged. Copy it again.").arg(where));
    case ImportError::too_large: return at(Words::tr("%1 is larger than the limits allow.").arg(where));
    case ImportError::nothing_solid: return at(Words::tr("%1 holds nothing solid.").arg(where));
    case ImportError::no_mesh: return at(Words::tr("%1 holds no surface.").arg(where));
    case ImportError::mesh_not_found: return at(Words::tr("There is no part called %1.").arg(where));
    case ImportError::mesh_empty: return at(Words::tr("The part %1 encloses nothing.").arg(where));
    case ImportError::mesh_open: return at(Words::tr("The surface is open at %1 mm. Let it be mended, or close it there.").arg(where));
    case ImportError::mesh_not_oriented: return at(Words::tr("The surface is turned inside out at %1 mm. Let it be mended.").arg(where));
    case ImportError::mesh_ambiguous: return at(Words::tr("The part %1 cuts itself.").arg(where));
    case ImportError::bad_option: return {Words::tr("An option does not fit."), where};
    case ImportError::crashed: return at(Words::tr("Reading %1 broke off.").arg(where));
    case ImportError::time_limit: return at(Words::tr("Reading %1 took longer than allowed.").arg(where));
    case ImportError::out_of_memory: return at(Words::tr("Reading %1 wanted more memory than allowed.").arg(where));
    case ImportError::cancelled: return {Words::tr("Reading was cancelled."), kept};
    case ImportError::not_started: return {Words::tr("Reading could not be started."), kept};
    case ImportError::unknown_generator: return at(Words::tr("Specimens of the kind %1 are not known.").arg(where));
  }
  return at(where);
}

Told tell(const PortFailure& f) {
  const QString where = place(f.where);
  switch (f.code) {
    case PortError::not_found:
      return {Words::tr("The device was not found."), Words::tr("%1 is not connected. Check cable and power.").arg(where)};
    case PortError::no_permission:
      return {Words::tr("This user may not open the device."), Words::tr("%1 refused.").arg(where)};
    case PortError::busy:
      return {Words::tr("Another program holds the device."), Words::tr("Close it and try %1 again.").arg(where)};
    case PortError::bad_file:
      return {Words::tr("The script cannot be read."), Words::tr("Look at %1.").arg(where)};
    case PortError::io:
      return {Words::tr("The device does not answer."), Words::tr("%1: check cable and power.").arg(where)};
  }
  return {Words::tr("The device failed."), where};
}

Told tell(const RunFailure& f) {
  // What the room below says is nearer to the cause; here comes only what it meant for the go.
  if (const auto* code = std::get_if<StorageError>(&f.cause)) return tell(StorageFailure{*code, f.where, f.detail});
  if (const auto* code = std::get_if<ImportError>(&f.cause)) return tell(ImportFailure{*code, f.where, f.detail});
  if (const auto* code = std::get_if<PortError>(&f.cause)) return tell(PortFailure{*code, f.where, f.detail});
  if (const auto* code = std::get_if<FormatError>(&f.cause)) return tell(FormatFailure{*code, f.where, f.detail});
  const QString where = place(f.where);
  switch (f.code) {
    case RunError::specimen:
      return {Words::tr("The tooth of this exercise cannot be made."),
              Words::tr("Look at %1. No go was started.").arg(where)};
    case RunError::scene:
      return {Words::tr("This exercise cannot be played."), Words::tr("Look at %1. No go was started.").arg(where)};
    case RunError::device:
      return {Words::tr("The device did not open."), Words::tr("%1 refused. No go was started.").arg(where)};
    case RunError::device_class:
      return {Words::tr("This exercise does not admit this device."),
              Words::tr("Connected is: %1. No go was started.").arg(device_name(f.where))};
    case RunError::scenario:
      return {Words::tr("The stored exercise cannot be read."), Words::tr("Look at %1. Nothing was changed.").arg(where)};
    case RunError::storage:
      return {Words::tr("The database refused."), Words::tr("%1 was not written. Goes before it are kept.").arg(where)};
    case RunError::recording_failed:
      return {Words::tr("The go could not be recorded any further."),
              Words::tr("It is kept up to the last second before %1 failed.").arg(where)};
    case RunError::not_deterministic:
      return {Words::tr("Two computations of this go differ."),
              Words::tr("It was stopped at tick %1 and is not graded; the recording is kept.").arg(where)};
    case RunError::fell_behind:
      return {Words::tr("This computer is too slow for this exercise."),
              Words::tr("The go ended as interrupted. All of it is kept and can be graded as it stands.")};
    case RunError::wrong_state:
      return {Words::tr("This go is not in a state that allows it."), Words::tr("Nothing was changed.")};
    case RunError::other_engine:
      return {Words::tr("This go was recorded by another version of Cusp."),
              Words::tr("It opens with its stored tooth and grade, but is not computed again (engine %1).").arg(where)};
    case RunError::specimen_changed:
      return {Words::tr("The tooth is not the one this go began with."),
              Words::tr("The stored grade is kept; the tooth of %1 cannot be shown.").arg(where)};
  }
  return {Words::tr("The go could not be played."), where};
}

Told tell(const RealtimeGrant& grant) {
  if (grant.realtime()) return {Words::tr("The device goes before other programs."), {}};
  const QString what = Words::tr("Other programs may delay the device.");
  switch (grant.refusal) {
    case RealtimeRefusal::not_permitted:
      return {what, Words::tr("This user has no right to real-time priority. An administrator can give it (rtprio).")};
    case RealtimeRefusal::no_service:
      return {what, Words::tr("Install rtkit, or give this user the right to real-time priority (rtprio).")};
    case RealtimeRefusal::none:
    case RealtimeRefusal::not_asked: break;
  }
  return {what, {}};
}

Told tell(Fault fault) {
  switch (fault) {
    case Fault::none: return {};
    case Fault::jump:
      return {Words::tr("The device jumped."), Words::tr("The force is off and the clock stands still. Your work is kept.")};
    case Fault::late:
      return {Words::tr("The device answered too late."),
              Words::tr("The force is off and the clock stands still. Your work is kept.")};
    case Fault::stale:
    case Fault::gone:
      return {Words::tr("The device went quiet."),
              Words::tr("The force is off and the clock stands still. Check the cable; your work is kept.")};
    case Fault::not_finite:
      return {Words::tr("The device sent a position that is none."),
              Words::tr("The force is off and the clock stands still. Your work is kept.")};
  }
  return {};
}

QString role_name(Role role) {
  switch (role) {
    case Role::student: return Words::tr("Student");
    case Role::instructor: return Words::tr("Teacher");
    case Role::administrator: return Words::tr("Administrator");
  }
  return {};
}

QString state_name(SessionState state) {
  switch (state) {
    case SessionState::running: return Words::tr("Running");
    case SessionState::interrupted: return Words::tr("Interrupted");
    case SessionState::finished: return Words::tr("Not graded");
    case SessionState::graded: return Words::tr("Graded");
    case SessionState::closed: return Words::tr("Closed");
  }
  return {};
}

QString kind_name(SessionKind kind) {
  switch (kind) {
    case SessionKind::practice: return Words::tr("Practice");
    case SessionKind::assessment: return Words::tr("Assessment");
    case SessionKind::try_it: return Words::tr("Try it");
    case SessionKind::try_out: return Words::tr("Try-out");
  }
  return {};
}

QString device_name(const std::string& device_class) {
  if (device_class == "pointer") return Words::tr("Mouse and keys");
  if (device_class == "falcon") return QStringLiteral("Falcon");
  if (device_class == "emulated-falcon") return Words::tr("Emulated Falcon");
  if (device_class == "inverse3") return QStringLiteral("Inverse3");
  if (device_class == "scripted") return Words::tr("Scripted hand");
  return text(device_class);
}

QString tissue_name(Tissue tissue) {
  switch (tissue) {
    case Tissue::empty: return Words::tr("Nothing");
    case Tissue::enamel: return Words::tr("Enamel");
    case Tissue::dentine: return Words::tr("Dentine");
    case Tissue::carious_dentine: return Words::tr("Decay");
    case Tissue::cementum: return Words::tr("Cementum");
    case Tissue::pulp: return Words::tr("Pulp");
    case Tissue::bone: return Words::tr("Bone");
    case Tissue::gingiva: return Words::tr("Gingiva");
    case Tissue::ligament: return Words::tr("Ligament");
    case Tissue::amalgam: return Words::tr("Amalgam");
    case Tissue::composite: return Words::tr("Composite");
    case Tissue::plastic: return Words::tr("Plastic");
    case Tissue::carious_enamel: return Words::tr("Decayed enamel");
  }
  if (tissue == kNeighbourEnamel) return Words::tr("Neighbour enamel");
  if (tissue == kNeighbourDentine) return Words::tr("Neighbour dentine");
  if (tissue == kFirmCariousDentine) return Words::tr("Firm decay");
  return Words::tr("Material %1").arg(static_cast<int>(tissue) - 15);
}

QString metric_name(const std::string& m) {
  if (m == "target_removed") return Words::tr("Target removed");
  if (m == "overcut_leeway_floor") return Words::tr("Leeway used, floor");
  if (m == "overcut_leeway_side") return Words::tr("Leeway used, walls");
  if (m == "overcut_beyond_floor") return Words::tr("Floor cut too far");
  if (m == "overcut_beyond_side") return Words::tr("Walls cut too far");
  if (m == "undercut") return Words::tr("Left standing");
  if (m == "depth_least") return Words::tr("Floor depth, shallowest");
  if (m == "depth_mean") return Words::tr("Floor depth, mean");
  if (m == "depth_most") return Words::tr("Floor depth, deepest");
  if (m == "remaining_over_pulp") return Words::tr("Dentine over pulp");
  if (m == "time") return Words::tr("Time");
  if (m == "force_peak") return Words::tr("Peak push");
  if (m == "force_mean") return Words::tr("Mean push");
  if (m == "pulp_exposure") return Words::tr("Pulp opened");
  if (m == "dry_cutting_time") return Words::tr("Cut without coolant");
  if (m == "temperature_rise_peak") return Words::tr("Tooth warmer by (not verified)");
  if (m == "dry_cutting") return Words::tr("Tooth overheated");
  if (m.starts_with("removed_")) {
    const std::string key = m.substr(8);
    if (const auto tissue = tissue_from_key(key)) return Words::tr("%1 removed").arg(tissue_name(*tissue));
    bool number = false;
    const int code = text(key).toInt(&number);
    if (number) return Words::tr("%1 removed").arg(tissue_name(static_cast<Tissue>(code)));
  }
  return text(m);
}

QString metric_unit(const std::string& m) {
  if (m == "target_removed") return u"%"_qs;
  if (m.starts_with("overcut_") || m == "undercut" || m.starts_with("removed_")) return u"mm3"_qs;
  if (m.starts_with("depth_") || m == "remaining_over_pulp") return u"mm"_qs;
  if (m == "time" || m == "dry_cutting_time") return u"s"_qs;
  if (m == "temperature_rise_peak") return u"K"_qs;
  if (m.starts_with("force_")) return u"N"_qs;
  return {};
}

QString critical_name(const std::string& critical) {
  if (critical == "pulp_exposure") return Words::tr("The pulp was opened");
  if (critical == "dry_cutting") return Words::tr("The tooth was overheated by cutting dry (criterion not verified)");
  return metric_name(critical);
}

namespace {

QString number_of(double value) {
  for (int decimals = 0; decimals < 3; ++decimals) {
    const double scaled = value * std::pow(10.0, decimals);
    if (std::abs(scaled - std::round(scaled)) < 1e-6) return format_number(value, decimals);
  }
  return format_number(value, 3);
}

QString with_unit(double value, const QString& unit) {
  return isolate(unit.isEmpty() ? number_of(value) : number_of(value) + QChar(0x00A0) + unit_text(unit));
}

}  // namespace

namespace {

/// As many decimals as keep value and limit apart, up to three, and never fewer than `least`: "96.97", not "97", of 97.
QString apart_from(double value, double limit, const QString& unit, int least) {
  int decimals = least;
  const auto same = [&](int n) { return format_number(value, n) == format_number(limit, n); };
  while (decimals < 3 && same(decimals)) ++decimals;
  return format_value({value, std::nullopt, unit, decimals});
}

}  // namespace

QString wanted_text(const Criterion& c) {
  const QString unit = metric_unit(c.metric);
  const Bands& b = c.bands;
  // A side whose three edges coincide has no edge: nothing lies beyond it.
  const bool open_low = b.fail_lo == b.ideal_lo && b.acc_lo == b.ideal_lo;
  const bool open_high = b.fail_hi == b.ideal_hi && b.acc_hi == b.ideal_hi;
  if (open_low && !open_high) return Words::tr("up to %1").arg(with_unit(b.ideal_hi, unit));
  if (open_high && !open_low) return Words::tr("%1 or more").arg(with_unit(b.ideal_lo, unit));
  if (b.ideal_lo == b.ideal_hi) return with_unit(b.ideal_lo, unit);
  return Words::tr("%1 to %2").arg(number_of(b.ideal_lo), with_unit(b.ideal_hi, unit));
}

QString reason_text(const CriterionGrade& g) {
  const auto arg = [&](const char* key) {
    const auto it = g.reason_args.find(key);
    return it == g.reason_args.end() ? 0.0 : it->second;
  };
  const QString unit = text(g.measure.unit);
  if (g.reason_code == "little_drilled") {
    // Down to the tenth: "100 %" is never said where points are missing.
    const double percent = std::floor(arg("share") * 1000 + 1e-6) / 10;
    return Words::tr("Counts only as far as the target is drilled: %1").arg(with_unit(percent, u"%"_qs));
  }
  const double value = arg("value"), limit = arg("limit");
  const QString v = format({value, std::nullopt, unit, 2}), l = with_unit(limit, unit);
  const QString apart = format({std::abs(value - limit), std::nullopt, unit, 2});
  if (g.reason_code == "full") return Words::tr("Full points");
  if (g.reason_code == "not_measured") return Words::tr("Could not be measured");
  if (g.reason_code == "too_deep") return Words::tr("%1, %2 deeper than %3").arg(v, apart, l);
  if (g.reason_code == "too_shallow") return Words::tr("%1, %2 short of %3").arg(v, apart, l);
  const QString whole = apart_from(value, limit, unit, unit == u"%" ? 1 : 2);
  if (g.reason_code == "too_much") return Words::tr("%1; full points up to %2").arg(whole, l);
  if (g.reason_code == "too_dry") return Words::tr("%1 without coolant; full points up to %2").arg(whole, l);
  if (g.reason_code == "too_warm") return Words::tr("%1 warmer; full points up to %2").arg(whole, l);
  if (g.reason_code == "too_little") {
    return g.id == "target_removed" ? Words::tr("%1 removed; full points from %2").arg(whole, l)
                                    : Words::tr("%1; full points from %2").arg(whole, l);
  }
  return text(g.reason_code);
}

int point_forms(double points) { return format_points(points) == format_points(1) ? 1 : 2; }

QString lost_text(const CriterionGrade& g) {
  const double lost = g.points_max - g.points;
  return Words::tr("%1: %2 point(s) lost", nullptr, point_forms(lost)).arg(metric_name(g.id), format_points(lost));
}

QString advice_text(const CriterionGrade& g) {
  // What was drilled too little is advised about once, by the target's own criterion.
  if (g.reason_code == "full" || g.reason_code == "not_measured" || g.reason_code == "little_drilled") return {};
  const std::string& m = g.id;
  if (m == "target_removed") return Words::tr("Turn the view and look for what still stands inside the target line.");
  if (m == "overcut_leeway_floor" || m == "overcut_beyond_floor")
    return Words::tr("Lift off and read the depth before you go deeper.");
  if (m == "overcut_leeway_side" || m == "overcut_beyond_side")
    return Words::tr("Keep the burr’s edge inside the target line; push less near the walls.");
  if (m == "undercut") return Words::tr("Turn the view and clear the corners along the walls.");
  if (m.starts_with("depth_")) {
    if (g.reason_code == "too_deep") return Words::tr("Stop pushing before the wanted depth and move sideways.");
    return Words::tr("Go on to the wanted depth over the whole floor.");
  }
  if (m == "remaining_over_pulp") return Words::tr("Keep away from the pulp: stay above the wanted floor.");
  if (m == "force_peak" || m == "force_mean") return Words::tr("Push less; let the burr do the work.");
  if (m == "time") return Words::tr("Plan the way of the burr before the first cut.");
  if (g.reason_code == "too_dry") return Words::tr("Run the coolant before the burr touches the tooth.");
  if (g.reason_code == "too_warm") return Words::tr("Run the coolant, push less, and lift off now and then.");
  if (g.reason_code == "too_much") return Words::tr("Take away less of it.");
  return Words::tr("Take away more of it.");
}

}  // namespace cusp
