#include "ui/text/thinning_text.h"

#include <QStringList>

#include "ui/text/text.h"
#include "ui/widgets/format.h"

namespace cusp::ui {
namespace {

QString kept_part(KeptBecause why, int count) {
  switch (why) {
    case KeptBecause::other_station: return Text::tr("%1 of another station").arg(count);
    case KeptBecause::assessment: return Text::tr("%1 from assessments").arg(count);
    case KeptBecause::unfinished: return Text::tr("%1 not finished").arg(count);
    case KeptBecause::ungraded: return Text::tr("%1 without a grade").arg(count);
    case KeptBecause::stated: return Text::tr("%1 that an examiner overrode, confirmed or released").arg(count);
    case KeptBecause::broken: return Text::tr("%1 that cannot be verified").arg(count);
  }
  return {};
}

}  // namespace

QString recording_size_text(std::uint64_t bytes) { return installed_locale().formattedDataSize(static_cast<qint64>(bytes), 1); }

QString thinned_text(const ThinningReport& report, ThinningMode mode) {
  const int count = static_cast<int>(report.attempts);
  const QString size = recording_size_text(report.bytes);
  if (mode == ThinningMode::dry_run) return Text::tr("%n recording(s) would be thinned: %1.", nullptr, count).arg(size);
  return Text::tr("%n recording(s) were thinned: %1.", nullptr, count).arg(size);
}

QString kept_text(const KeptTraces& kept) {
  QStringList parts;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (kept[i] > 0) parts += kept_part(static_cast<KeptBecause>(i), static_cast<int>(kept[i]));
  }
  return parts.isEmpty() ? QString() : Text::tr("Kept whole: %1.").arg(parts.join(u", "));
}

}  // namespace cusp::ui
