#include "ui/text/incident_text.h"

#include "ui/text/text.h"
#include "ui/widgets/format.h"

namespace cusp::ui {
namespace {

Told what_it_means(std::string_view incident) {
  if (incident == "rolled_back") {
    return {Words::tr("The records are older than they were."),
            Words::tr("An earlier copy was put in their place, or entries were taken out: results may be missing.")};
  }
  if (incident == "counter_missing") {
    return {Words::tr("The counter beside the records’ key is missing."),
            Words::tr("An earlier copy of the records put in their place would not have been noticed.")};
  }
  if (incident == "counter_broken") {
    return {Words::tr("The counter beside the records’ key is not theirs."),
            Words::tr("It was changed or comes from other records: an earlier copy would not have been noticed.")};
  }
  return {Words::tr("The records’ audit log was changed."),
          Words::tr("Its last entries were changed or taken out: results or accounts may have been too.")};
}

}  // namespace

Told tell_incident(std::string_view incident, const std::filesystem::path& database) {
  Told told = what_it_means(incident);
  told.more += u' ' + Words::tr("Before you rely on them, look at what this command names: cusp history %1 verify")
                          .arg(isolate(QString::fromStdString(database.string())));
  return told;
}

Told tell_reading_only(const StorageFailure& cause, const std::filesystem::path& database) {
  return {tell(cause).what, Words::tr("Results and reports can be read. Nothing can be drilled or changed until %1 can be "
                                      "written again.")
                                .arg(isolate(QString::fromStdString(database.filename().string())))};
}

}  // namespace cusp::ui
