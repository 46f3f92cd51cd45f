#include "ui/app/import_words.h"

#include <QCoreApplication>

#include "ui/widgets/format.h"

namespace cusp {
namespace {

struct ImportWords {
  Q_DECLARE_TR_FUNCTIONS(cusp::ImportWords)
};

QString millimetres(double mm, int decimals) {
  return format_value({.value = mm, .unit = QStringLiteral("mm"), .decimals = decimals});
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

QString tell(const ImportRemark& r) {
  const auto n = [&](std::size_t i) { return i < r.numbers.size() ? r.numbers[i] : 0.0; };
  const int count = static_cast<int>(n(0));
  const QString mesh = isolate(QString::fromStdString(r.subject));
  switch (r.code) {
    case RemarkCode::resampled:
      return ImportWords::tr("Its voxels of %1 were resampled to cubes of %2.")
          .arg(size_text({n(0), n(1), n(2)}, QStringLiteral("mm"), 3), millimetres(n(3), 3));
    case RemarkCode::straightened:
      return ImportWords::tr("Its axes were oblique; it was turned by %1°, its shape is as it was.").arg(isolate(format_number(n(0), 1)));
    case RemarkCode::spacing_assumed: return ImportWords::tr("The file does not say how long a unit is; what was chosen was taken.");
    case RemarkCode::identity_left_out: return ImportWords::tr("Nothing about the patient was read.");
    case RemarkCode::one_of_series:
      return ImportWords::tr("The folder holds %n series; the one with %1 slices was read.", nullptr, count).arg(static_cast<int>(n(1)));
    case RemarkCode::points_joined: return ImportWords::tr("In %1 %n point(s) that lay in one place were joined.", nullptr, count).arg(mesh);
    case RemarkCode::triangles_dropped: return ImportWords::tr("In %1 %n triangle(s) too many were left out.", nullptr, count).arg(mesh);
    case RemarkCode::triangles_turned: return ImportWords::tr("In %1 %n triangle(s) were turned round.", nullptr, count).arg(mesh);
    case RemarkCode::holes_closed:
      return ImportWords::tr("In %1 %n hole(s) were closed, the widest of %2.", nullptr, count).arg(mesh, millimetres(n(1), 2));
    case RemarkCode::pieces_removed: return ImportWords::tr("%n voxel(s) of loose pieces were left out.", nullptr, count);
    case RemarkCode::hollows_filled: return ImportWords::tr("%n voxel(s) of closed hollows were filled.", nullptr, count);
  }
  return {};
}

}  // namespace cusp
