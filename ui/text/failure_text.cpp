#include "ui/text/failure_text.h"

#include <variant>

#include "ui/text/import_text.h"
#include "ui/text/sentences.h"
#include "ui/text/text.h"
#include "ui/widgets/format.h"

namespace cusp::ui {
namespace {

/// "/target/depth_mm" or "scenario.json#/target/depth_mm" as it stands; a path is shown whole.
QString place(const std::string& where) { return isolate(text(where)); }

}  // namespace

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
    case FormatError::unknown_bur:
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
  if (const auto figures = limit_figures(f.detail)) return {limit_title(figures->kind), limit_text(where, *figures) + u' ' + kept};
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

}  // namespace cusp::ui
