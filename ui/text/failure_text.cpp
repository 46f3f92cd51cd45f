#include "ui/text/failure_text.h"

#include <cmath>
#include <variant>

#include "ui/text/import_text.h"
#include "ui/text/names.h"
#include "ui/text/text.h"
#include "ui/widgets/format.h"

namespace cusp::ui {
namespace {

/// "/target/depth_mm" or "scenario.json#/target/depth_mm" as it stands; a path is shown whole.
QString place(const std::string& where) { return isolate(text(where)); }

}  // namespace

Message describe(const FormatFailure& f) {
  const QString where = place(f.where), detail = text(f.detail);
  const QString kept = Text::tr("Nothing was changed.");
  const QString what = Text::tr("This exercise cannot be read.");
  const auto at = [&](const QString& why) { return Message{what, why + u' ' + kept}; };
  switch (f.code) {
    case FormatError::unreadable: return at(Text::tr("The file %1 cannot be opened.").arg(where));
    case FormatError::too_large: return at(Text::tr("%1 is larger than any exercise.").arg(where));
    case FormatError::broken_json: return at(Text::tr("The text breaks off or is malformed at %1.").arg(where));
    case FormatError::duplicate_key: return at(Text::tr("%1 stands there twice.").arg(where));
    case FormatError::newer_format:
      return at(Text::tr("%1 was written by a newer version of Cusp (format %2).").arg(where, detail));
    case FormatError::unknown_key: return at(Text::tr("%1 is not known.").arg(where));
    case FormatError::missing_key: return at(Text::tr("%1 is missing.").arg(where));
    case FormatError::wrong_type: return at(Text::tr("%1 has to be: %2.").arg(where, detail));
    case FormatError::out_of_range: return at(Text::tr("%1 has to lie in %2.").arg(where, detail));
    case FormatError::not_finite: return at(Text::tr("%1 is not a number.").arg(where));
    case FormatError::bad_id: return at(Text::tr("%1 is not an identity.").arg(where));
    case FormatError::bad_language: return at(Text::tr("%1 names no language, or English is missing.").arg(where));
    case FormatError::bad_file_name: return at(Text::tr("%1 leads out of the exercise’s folder.").arg(where));
    case FormatError::duplicate_value: return at(Text::tr("%1 is named twice.").arg(where));
    case FormatError::unknown_tissue:
    case FormatError::unknown_metric:
    case FormatError::unknown_critical:
    case FormatError::unknown_method:
    case FormatError::unknown_generator:
    case FormatError::unknown_shape:
    case FormatError::unknown_phenomenon:
    case FormatError::unknown_face:
    case FormatError::unknown_severity:
    case FormatError::unknown_hardness:
    case FormatError::unknown_bur:
      return at(detail.isEmpty() ? Text::tr("%1 names something that is not known.").arg(where)
                                 : Text::tr("%1 names something that is not known: %2.").arg(where, detail));
    case FormatError::bad_target_name:
      return at(Text::tr("%1 is no name of a target: a letter, then letters, digits and _, all small.").arg(where));
    case FormatError::unknown_landmark: return at(Text::tr("%1 names no kind or state of a landmark: %2.").arg(where, detail));
    case FormatError::unknown_level: return at(Text::tr("%1 names no level of an exercise: %2.").arg(where, detail));
    case FormatError::unknown_builtin: return at(Text::tr("No exercise called %1 comes with the program.").arg(where));
    case FormatError::foreign_file: return at(Text::tr("%1 is not an exercise that Cusp saved as a file.").arg(where));
    case FormatError::truncated: return at(Text::tr("%1 is not whole: it breaks off. Copy the file again.").arg(where));
    case FormatError::damaged: return at(Text::tr("%1 was damaged or changed after it was saved. Copy the file again.").arg(where));
    case FormatError::missing_file: return at(Text::tr("%1 is missing in the file.").arg(where));
    case FormatError::unnamed_file: return at(Text::tr("%1 does not belong in the file of an exercise.").arg(where));
    case FormatError::unwritable:
      return {Text::tr("The exercise cannot be saved as a file."),
              detail.isEmpty() ? Text::tr("%1 cannot be written. Choose another folder.").arg(where)
                               : Text::tr("%1 cannot be written: %2. Choose another folder.").arg(where, detail)};
  }
  return at(where);
}

Message describe(const ExerciseFileFailure& failure) {
  if (const auto* format = std::get_if<FormatFailure>(&failure)) return describe(*format);
  if (const auto* import = std::get_if<ImportFailure>(&failure)) return describe(*import);
  return {Text::tr("This exercise cannot be used."),
          Text::tr("The checks refuse it at %1. Nothing was changed.").arg(place(std::get<Finding>(failure).path))};
}

Message describe(const ImportFailure& f) {
  const QString where = place(f.where), detail = text(f.detail);
  const QString kept = Text::tr("Nothing was changed.");
  const QString what = Text::tr("This file cannot be read.");
  const auto at = [&](const QString& why) { return Message{what, why + u' ' + kept}; };
  if (const auto figures = limit_figures(f.detail)) return {limit_title(figures->kind), limit_text(where, *figures) + u' ' + kept};
  switch (f.code) {
    case ImportError::missing_file: return at(Text::tr("There is no file %1.").arg(where));
    case ImportError::io:
      return {Text::tr("This file cannot be read or written."),
              detail.isEmpty() ? where + u' ' + kept : Text::tr("%1: %2.").arg(where, detail) + u' ' + kept};
    case ImportError::unknown_format: return at(Text::tr("%1 is of a kind that is not read here.").arg(where));
    case ImportError::bad_header: return at(Text::tr("Its head is wrong at %1.").arg(where));
    case ImportError::unsupported: return at(Text::tr("It uses %1, which is not read here.").arg(where));
    case ImportError::bad_sizes: return at(Text::tr("The sizes at %1 make no volume.").arg(where));
    case ImportError::bad_spacing: return at(Text::tr("At %1 its cells are not evenly spaced, or not between 0.005 and 5 mm.").arg(where));
    case ImportError::bad_orientation: return at(Text::tr("The axes at %1 are oblique or not known.").arg(where));
    case ImportError::bad_tissue: return at(Text::tr("%1 names no tissue.").arg(where));
    case ImportError::truncated: return at(Text::tr("%1 ends too early. Copy it again.").arg(where));
    case ImportError::corrupt: return at(Text::tr("%1 is damaged. Copy it again.").arg(where));
    case ImportError::too_large: return at(Text::tr("%1 is larger than the limits allow.").arg(where));
    case ImportError::nothing_solid: return at(Text::tr("%1 holds nothing solid. Check its unit, and which grey values are tissue.").arg(where));
    case ImportError::no_mesh: return at(Text::tr("%1 holds no surface.").arg(where));
    case ImportError::mesh_not_found: return at(Text::tr("There is no part called %1.").arg(where));
    case ImportError::mesh_empty: return at(Text::tr("The part %1 encloses nothing.").arg(where));
    case ImportError::mesh_open: return at(Text::tr("The surface is open at %1 mm. Let it be mended, or close it there.").arg(where));
    case ImportError::mesh_not_oriented: return at(Text::tr("The surface is turned inside out at %1 mm. Let it be mended.").arg(where));
    case ImportError::mesh_ambiguous: return at(Text::tr("The part %1 cuts itself.").arg(where));
    case ImportError::bad_option: return {Text::tr("An option does not fit."), where};
    case ImportError::crashed: return at(Text::tr("Reading %1 broke off.").arg(where));
    case ImportError::time_limit: return at(Text::tr("Reading %1 took longer than allowed.").arg(where));
    case ImportError::out_of_memory: return at(Text::tr("Reading %1 wanted more memory than allowed.").arg(where));
    case ImportError::cancelled: return {Text::tr("Reading was cancelled."), kept};
    case ImportError::not_started: return {Text::tr("Reading could not be started."), kept};
    case ImportError::unknown_generator: return at(Text::tr("Specimens of the kind %1 are not known.").arg(where));
    case ImportError::code_taken:
      return {Text::tr("This file cannot be used."), Text::tr("In %1 the tissue %2 has the code of a grown tooth’s: 29 and 30 are a neighbour’s, 31 is firm caries. Give it one from 16 to 28.").arg(where, detail) + u' ' + kept};
  }
  return at(where);
}

Message describe(const PortFailure& f) {
  const QString where = place(f.where);
  switch (f.code) {
    case PortError::not_found:
      return {Text::tr("The device was not found."), Text::tr("%1 is not connected. Check cable and power.").arg(where)};
    case PortError::no_permission:
      return {Text::tr("This user may not open the device."), Text::tr("%1 refused. The Device page shows the line that permits it.").arg(where)};
    case PortError::busy:
      return {Text::tr("Another program holds the device."), Text::tr("Close it and try %1 again.").arg(where)};
    case PortError::bad_file:
      return {Text::tr("The script cannot be read."), Text::tr("Look at %1.").arg(where)};
    case PortError::io:
      if (f.detail == kStandsStill) return {Text::tr("The driver of the device stands still."), Text::tr("%1: unplug it and plug it in again.").arg(where)};
      return {Text::tr("The device does not answer."), Text::tr("%1: check cable and power.").arg(where)};
  }
  return {Text::tr("The device failed."), where};
}

Message describe(OperatorCutError error, double tool_tilt_deg) {
  switch (error) {
    case OperatorCutError::no_path:
      if (tool_tilt_deg != 0.0) {
        const QString tilt = format({tool_tilt_deg, std::nullopt, QStringLiteral("deg"), tool_tilt_deg == std::round(tool_tilt_deg) ? 0 : 1});
        return {Text::tr("The operator cannot cut it."), Text::tr("No bur of the exercise fits into its target while the handpiece is tilted by %1.").arg(tilt)};
      }
      return {Text::tr("The operator cannot cut it."), Text::tr("No bur of the exercise fits into its target.")};
    case OperatorCutError::too_much_cut:
      return {Text::tr("The operator cannot cut it."), Text::tr("More is cut than a volume of this exercise can keep.")};
  }
  return {};
}

Message describe(const SessionFailure& f) {
  // The code of the module below is nearer to the cause; SessionError names only the consequence.
  if (const auto* code = std::get_if<StorageError>(&f.cause)) return describe(StorageFailure{*code, f.where, f.detail});
  if (const auto* code = std::get_if<ImportError>(&f.cause)) return describe(ImportFailure{*code, f.where, f.detail});
  if (const auto* code = std::get_if<PortError>(&f.cause)) return describe(PortFailure{*code, f.where, f.detail});
  if (const auto* code = std::get_if<FormatError>(&f.cause)) return describe(FormatFailure{*code, f.where, f.detail});
  const QString where = place(f.where);
  switch (f.code) {
    case SessionError::specimen:
      return {Text::tr("The tooth of this exercise cannot be made."),
              Text::tr("Look at %1. No attempt was started.").arg(where)};
    case SessionError::scene:
      return {Text::tr("This exercise cannot be played."), Text::tr("Look at %1. No attempt was started.").arg(where)};
    case SessionError::device:
      return {Text::tr("The device did not open."), Text::tr("%1 refused. No attempt was started.").arg(where)};
    case SessionError::device_class:
      return {Text::tr("This exercise does not admit this device."),
              Text::tr("Connected is: %1. No attempt was started. Staff choose the device on the page Device.").arg(device_name(f.where))};
    case SessionError::device_axes:
      return {Text::tr("This exercise needs a device that senses %1 axes.").arg(QString::fromStdString(f.detail)),
              Text::tr("Connected is: %1. No attempt was started. Staff choose the device on the page Device.").arg(device_name(f.where))};
    case SessionError::scenario:
      return {Text::tr("The stored exercise cannot be read."), Text::tr("Look at %1. Nothing was changed.").arg(where)};
    case SessionError::storage:
      return {Text::tr("The database refused."), Text::tr("%1 was not written. Earlier attempts are kept.").arg(where)};
    case SessionError::recording_failed:
      return {Text::tr("The attempt could not be recorded any further."),
              Text::tr("It is kept up to the last second before %1 failed.").arg(where)};
    case SessionError::not_deterministic:
      return {Text::tr("Two computations of this attempt differ."),
              Text::tr("It was stopped at tick %1 and is not graded; the recording is kept.").arg(where)};
    case SessionError::fell_behind:
      return {Text::tr("This computer is too slow for this exercise."),
              Text::tr("The attempt ended as interrupted. All of it is kept and can be graded as it stands.")};
    case SessionError::wrong_state:
      return {Text::tr("This attempt is not in a state that allows it."), Text::tr("Nothing was changed.")};
    case SessionError::other_engine:
      return {Text::tr("This attempt was recorded by another version of Cusp."),
              Text::tr("It opens with its stored tooth and grade, but is not computed again (engine %1).").arg(where)};
    case SessionError::specimen_changed:
      return {Text::tr("The tooth is not the one this attempt began with."),
              Text::tr("The stored grade is kept; the tooth of %1 cannot be shown.").arg(where)};
    case SessionError::no_tooth:
      return {Text::tr("No tooth was found that suits this exercise."),
              Text::tr("Tell the invigilator. No attempt was started or counted (%1).").arg(where)};
    case SessionError::driver_silent:
      return {Text::tr("The driver of the device stands still."),
              Text::tr("The attempt ended as interrupted. What was recorded until then is kept: continue it, or have it graded as it stands. Before that, unplug %1 and plug it in again.")
                  .arg(where)};
  }
  return {Text::tr("The attempt could not be played."), where};
}

Message describe(const RealtimeGrant& grant) {
  if (grant.realtime()) return {Text::tr("The device goes before other programs."), {}};
  const QString what = Text::tr("Other programs may delay the device.");
  switch (grant.refusal) {
    case RealtimeRefusal::not_permitted:
      return {what, Text::tr("This user has no right to real-time priority. An administrator can give it (rtprio).")};
    case RealtimeRefusal::no_service:
      return {what, Text::tr("Install rtkit, or give this user the right to real-time priority (rtprio).")};
    case RealtimeRefusal::none:
    case RealtimeRefusal::not_asked: break;
  }
  return {what, {}};
}

Message describe(Fault fault) {
  switch (fault) {
    case Fault::none: return {};
    case Fault::jump:
      return {Text::tr("The device jumped."), Text::tr("The force is off and the clock stands still. Your work is kept.")};
    case Fault::late:
      return {Text::tr("The device answered too late."),
              Text::tr("The force is off and the clock stands still. Your work is kept.")};
    case Fault::stale:
    case Fault::gone:
      return {Text::tr("The device went quiet."),
              Text::tr("The force is off and the clock stands still. Check the cable; your work is kept.")};
    case Fault::not_finite:
      return {Text::tr("The device sent a position that is none."),
              Text::tr("The force is off and the clock stands still. Your work is kept.")};
  }
  return {};
}

}  // namespace cusp::ui
