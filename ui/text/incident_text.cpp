#include "ui/text/incident_text.h"

#include "ui/text/text.h"
#include "ui/widgets/format.h"

namespace cusp::ui {
namespace {

Message what_it_means(std::string_view incident) {
  if (incident == "rolled_back") {
    return {Text::tr("The records are older than they were."),
            Text::tr("An earlier copy was put in their place, or entries were taken out: results may be missing.")};
  }
  if (incident == "counter_missing") {
    return {Text::tr("The counter beside the records’ key is missing."),
            Text::tr("An earlier copy of the records put in their place would not have been noticed.")};
  }
  if (incident == "counter_broken") {
    return {Text::tr("The counter beside the records’ key is not theirs."),
            Text::tr("It was changed or comes from other records: an earlier copy would not have been noticed.")};
  }
  return {Text::tr("The records’ audit log was changed."),
          Text::tr("Its last entries were changed or taken out: results or accounts may have been too.")};
}

}  // namespace

Message describe_incident(std::string_view incident, const std::filesystem::path& database) {
  Message message = what_it_means(incident);
  message.more += u' ' + Text::tr("Before you rely on them, look at what this command names: cusp history %1 verify")
                          .arg(isolate(QString::fromStdString(database.string())));
  return message;
}

Message describe_reading_only(const StorageFailure& cause, const std::filesystem::path& database) {
  return {describe(cause).what, Text::tr("Results and reports can be read. Nothing can be drilled or changed until %1 can be "
                                      "written again.")
                                .arg(isolate(QString::fromStdString(database.filename().string())))};
}

}  // namespace cusp::ui
