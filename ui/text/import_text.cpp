#include "ui/text/import_text.h"

#include <QCoreApplication>
#include <cmath>

#include "scenarios/import/size_question.h"
#include "ui/modules.h"
#include "ui/text/failure_text.h"
#include "ui/text/names.h"
#include "ui/widgets/format.h"

namespace cusp::ui {
namespace {

struct ImportText {
  Q_DECLARE_TR_FUNCTIONS(cusp::ui::ImportText)
};

QString millimetres(double mm, int decimals) {
  return format_value({.value = mm, .unit = QStringLiteral("mm"), .decimals = decimals});
}

QString square_millimetres(double mm2) { return format_value({.value = mm2, .unit = QStringLiteral("mm²"), .decimals = 1}); }
QString cubic_millimetres(double mm3) { return format_value({.value = mm3, .unit = QStringLiteral("mm³"), .decimals = mm3 < 1.0 ? 2 : 1}); }
QString tissue_of(double code) { return tissue_name(static_cast<Tissue>(static_cast<std::uint8_t>(code))); }

/// " Times 0.1 it would be 15.5 mm, times 10 …"
QString factors_text(const ImportRemark& r) {
  QStringList ways;
  for (std::size_t i = 1; i < r.numbers.size(); ++i)
    ways << ImportText::tr("× %1 = %2").arg(isolate(installed_locale().toString(r.numbers[i], 'g', 3)), millimetres(r.numbers[i] * r.numbers[0], 1));
  return ways.isEmpty() ? QString() : u' ' + ImportText::tr("Is the unit right? %1.").arg(ways.join(QStringLiteral("; ")));
}

/// What keeps the limit on a specimen's voxels.
QString way_out(const LimitFigures& f) {
  if (!(f.fits_mm > 0.0)) return ImportText::tr("Is the unit right? Else take fewer parts, or crop the file.");
  return ImportText::tr("Voxels of %1 would fit; or take fewer parts, or crop the file.").arg(isolate(installed_locale().toString(f.fits_mm, 'g', 3) + QChar(0x00A0) + u"mm"_qs));
}

}  // namespace

QString size_text(Vec3 size, const QString& unit, int decimals) {
  const auto number = [&](double v) { return format_number(v, decimals); };
  return isolate(QStringLiteral("%1 × %2 × %3").arg(number(size.x), number(size.y), number(size.z)) +
                 (unit.isEmpty() ? QString() : QChar(0x00A0) + unit));
}

QString place_text(Vec3 at_mm) {
  const auto number = [](double v) { return format_number(v, 1); };
  // A comma parts decimals in some languages.
  return isolate(QStringLiteral("(%1; %2; %3)").arg(number(at_mm.x), number(at_mm.y), number(at_mm.z)) + QChar(0x00A0) + u"mm"_qs);
}

QString describe(const ImportRemark& r) {
  const auto n = [&](std::size_t i) { return i < r.numbers.size() ? r.numbers[i] : 0.0; };
  const int count = static_cast<int>(n(0));
  const QString mesh = isolate(QString::fromStdString(r.subject)), other = isolate(QString::fromStdString(r.other));
  switch (r.code) {
    case RemarkCode::resampled:
      return ImportText::tr("Its voxels of %1 were resampled to cubes of %2.")
          .arg(size_text({n(0), n(1), n(2)}, QStringLiteral("mm"), 3), millimetres(n(3), 3));
    case RemarkCode::straightened:
      return ImportText::tr("Its axes were oblique; it was turned by %1°, its shape is as it was.").arg(isolate(format_number(n(0), 1)));
    case RemarkCode::spacing_assumed: return ImportText::tr("The file does not name its unit; the chosen one was taken.");
    case RemarkCode::identity_left_out: return ImportText::tr("Nothing about the patient was read.");
    case RemarkCode::one_of_series:
      return ImportText::tr("The folder holds %n series; the one with %1 slices was read.", nullptr, count).arg(static_cast<int>(n(1)));
    case RemarkCode::points_joined: return ImportText::tr("In %1 %n point(s) that lay in one place were joined.", nullptr, count).arg(mesh);
    case RemarkCode::triangles_dropped: return ImportText::tr("In %1 %n triangle(s) too many were left out.", nullptr, count).arg(mesh);
    case RemarkCode::triangles_turned: return ImportText::tr("In %1 %n triangle(s) were turned round.", nullptr, count).arg(mesh);
    case RemarkCode::holes_closed:
      return ImportText::tr("In %1 %n hole(s) were closed, the widest of %2.", nullptr, count).arg(mesh, millimetres(n(1), 2));
    case RemarkCode::components_removed: return ImportText::tr("%n voxel(s) of separate components were left out.", nullptr, count);
    case RemarkCode::hollows_filled: return ImportText::tr("%n voxel(s) of closed hollows were filled.", nullptr, count);
    case RemarkCode::shell_capped:
      return ImportText::tr("%1 was an open shell. Caps of %2 closed it; what lies between shell and cap is %3, unless another part lies there.")
          .arg(mesh, square_millimetres(n(0)), tissue_of(n(2)));
    case RemarkCode::precedence: return {};
    case RemarkCode::parts_overlap:
      return ImportText::tr("%1 and %2 overlap by %3; it became %4 (%1), not %5.")
          .arg(mesh, other, cubic_millimetres(n(0)), tissue_of(n(1)), tissue_of(n(2)));
    case RemarkCode::part_within:
      return ImportText::tr("%1 lies inside %2; its %3 became %4.").arg(mesh, other, cubic_millimetres(n(0)), tissue_of(n(1)));
    case RemarkCode::size_odd: return odd_size_text(n(0)) + factors_text(r);
    case RemarkCode::sides_assumed:
      return ImportText::tr("The file does not name the directions of its axes: the specimen may be the mirror image of the tooth. Compare them.");
    case RemarkCode::inside_out:
      return ImportText::tr("%1 was wound inside out, as a mirrored copy is: the specimen may be the mirror image of the tooth. Compare them.").arg(mesh);
  }
  return {};
}

QStringList describe(const std::vector<ImportRemark>& remarks) {
  QStringList out, order;
  bool given = false;
  for (const ImportRemark& r : remarks) {
    if (r.code == RemarkCode::precedence) {
      order << isolate(QString::fromStdString(r.subject));
      given = r.numbers.size() > 2 && r.numbers[2] > 0.0;
    } else {
      out << describe(r);
    }
  }
  if (order.isEmpty()) return out;
  const QString names = order.join(QStringLiteral(" > "));
  out << (given ? ImportText::tr("Where parts overlap, the order given decides: %1.").arg(names)
                : ImportText::tr("Where parts overlap, the innermost wins: %1.").arg(names));
  return out;
}

QString odd_size_text(double longest_mm) {
  const QString mm = millimetres(longest_mm, 1);
  return longest_mm < kLeastBelievedMm ? ImportText::tr("It is only %1 long: shorter than any tooth.").arg(mm)
                                       : ImportText::tr("It is %1 long: longer than any tooth or dental arch.").arg(mm);
}

QString limit_title(LimitKind kind) {
  switch (kind) {
    case LimitKind::voxels:
    case LimitKind::edge: return ImportText::tr("The specimen would be too large.");
    case LimitKind::file_voxels:
    case LimitKind::file_edge:
    case LimitKind::file_bytes:
    case LimitKind::file_count: return ImportText::tr("This file is too large.");
    case LimitKind::memory:
    case LimitKind::processor:
    case LimitKind::wall: break;
  }
  return ImportText::tr("The import was ended by a limit.");
}

QString limit_text(const QString& where, const LimitFigures& f) {
  const auto count = [](double v) { return isolate(installed_locale().toString(v, 'f', 0)); };
  const auto megabytes = [&](double bytes) { return count(std::ceil(bytes / 1e6)); };
  switch (f.kind) {
    case LimitKind::voxels: {
      const QString why = ImportText::tr("%1 would take %2 million voxels (%3 MB); %4 million (%5 MB) are allowed.")
                              .arg(where, count(f.asked / 1e6), megabytes(f.asked * kBytesPerVoxel), count(f.allowed / 1e6),
                                   megabytes(f.allowed * kBytesPerVoxel));
      return why + u' ' + way_out(f);
    }
    case LimitKind::edge:
      return ImportText::tr("%1 would be %2 voxels long; %3 are allowed.").arg(where, count(f.asked), count(f.allowed)) + u' ' + way_out(f);
    case LimitKind::file_voxels:
      return ImportText::tr("%1 holds %2 million voxels; %3 million are allowed. Crop it, or make it coarser, in the program that it comes from.")
          .arg(where, count(f.asked / 1e6), count(f.allowed / 1e6));
    case LimitKind::file_edge:
      return ImportText::tr("%1 is %2 voxels long; %3 are allowed. Crop it, or make it coarser, in the program that it comes from.")
          .arg(where, count(f.asked), count(f.allowed));
    case LimitKind::file_bytes:
      return ImportText::tr("%1 has %2 MB; %3 MB are allowed. Save it with fewer triangles.").arg(where, megabytes(f.asked), megabytes(f.allowed));
    case LimitKind::file_count: return ImportText::tr("%1 is made of more than %2 files.").arg(where, count(f.allowed));
    case LimitKind::memory:
      return ImportText::tr("Reading %1 took more than the %2 MB of memory that an import may use. Take larger voxels, or crop the file.")
          .arg(where, megabytes(f.allowed));
    case LimitKind::processor:
      return ImportText::tr("Reading %1 took more than the %2 s of processor time that an import may use. Take larger voxels, or crop the file.")
          .arg(where, count(f.allowed));
    case LimitKind::wall:
      return ImportText::tr("Reading %1 took longer than the %2 s that an import may last. Take larger voxels, or crop the file.")
          .arg(where, count(f.allowed));
  }
  return {};
}

}  // namespace cusp::ui
