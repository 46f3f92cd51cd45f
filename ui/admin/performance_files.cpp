// What the performance page writes and opens as files.

#include "storage/export/csv.h"
#include "ui/admin/performance.h"
#include "ui/text/language.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/save_csv.h"

namespace cusp::ui {

void Performance::choose_pack() {
  FileWish wish;
  wish.title = tr("Open an appeal pack");
  wish.filter = tr("Appeal pack (*.cusppack)");
  wish.saving = false;
  ports_.pick_file(this, wish, [this](const QString& path) { Q_EMIT pack_wanted(path); });
}

void Performance::export_csv() {
  CsvOptions options;
  options.language = current_language().toStdString();
  const auto csv = export_history(store_.context(), reader_, filter(), options);
  if (!csv) return show_failure(csv.error());
  save_csv(*band_, ports_, {tr("Export CSV"), u"cusp-performance-"_qs + ports_.now().toString(u"yyyy-MM-dd"_qs), csv->text,
                            tr("%n attempt(s) exported.", nullptr, static_cast<int>(csv->rows))});
}

}  // namespace cusp::ui
