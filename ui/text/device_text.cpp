#include "ui/text/device_text.h"

#include "ui/text/falcon_text.h"
#include "ui/text/text.h"
#include "ui/widgets/format.h"

namespace cusp::ui {

namespace {

/// Pre: a failure of InversePort, whose `where` is a code.
Message describe_inverse(const PortFailure& f) {
  if (f.code == PortError::not_found && f.where == "device")
    return {Text::tr("The Inverse3 was not found."),
            Text::tr("Its service answers, but it knows of no Inverse3. Check its cable and power, then try again.")};
  if (f.code == PortError::not_found)
    return {Text::tr("The service of the Inverse3 does not answer."), Text::tr("Start the maker’s service on this computer, then try again.")};
  return {Text::tr("The Inverse3 did not start."),
          Text::tr("Start the maker’s service anew, then try again. (%1)").arg(isolate(QString::fromStdString(f.detail)))};
}

}  // namespace

Message describe_on_device(const SessionFailure& f, std::string_view kind) {
  const auto* code = std::get_if<PortError>(&f.cause);
  if (code == nullptr) return describe(f);
  if (f.detail == kStandsStill) return describe(f);  // of any device: it was there, and its driver does not come back
  const PortFailure port{*code, f.where, f.detail};
  if (kind == "falcon") return describe_falcon(port);
  if (kind == "inverse3" && (f.where == "service" || f.where == "device")) return describe_inverse(port);
  return describe(f);
}

}  // namespace cusp::ui
