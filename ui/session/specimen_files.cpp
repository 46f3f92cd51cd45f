#include "ui/session/specimen_files.h"

#include <optional>
#include <utility>

#include "scenarios/format/content_hash.h"
#include "scenarios/specimens/specimens.h"
#include "ui/session/program_id.h"
#include "ui/session/scenery_blob.h"
#include "ui/session/specimen_blob.h"

namespace cusp::ui {
namespace {

Scenario only(const SpecimenSource& source) {
  Scenario out;
  out.specimen = source;
  return out;
}

const std::optional<std::string>& this_program() {
  static const std::optional<std::string> id = program_id();
  return id;
}

}  // namespace

bool SpecimenFiles::keeps(const SpecimenSource& source) {
  // Without the id a file of another build would look like one of this.
  return source.generator == "tooth" && this_program().has_value();
}

Hash256 SpecimenFiles::key(std::string_view what, const Scenario& scenario) {
  Scenario part = only(scenario.specimen);
  part.method = scenario.method;
  part.target = scenario.target;
  part.leeway = scenario.leeway;
  return Blake2b().add_text(what).add_text(this_program().value_or("")).add_text(content_hash(part).hex()).finish();
}

Outcome<std::shared_ptr<const Specimen>> SpecimenFiles::specimen(const Scenario& scenario, const std::filesystem::path& folder,
                                                                 const std::atomic<bool>* stop, const ToothProgress& progress) const {
  const Reading reading = reading_of(scenario.method);
  const Hash256 kept_as = key("specimen", only(scenario.specimen));
  if (keeps(scenario.specimen)) {
    const auto bytes = files_.read(kept_as);
    const auto kept = bytes ? specimen_from_bytes(*bytes) : std::nullopt;
    if (kept) return Specimen::build(*kept, reading);
  }
  auto grown = make_specimen(scenario.specimen, folder, stop, progress);
  if (!grown) return session_fail(SessionError::specimen, grown.error());
  if (keeps(scenario.specimen)) files_.keep(kept_as, specimen_bytes(*grown));
  return Specimen::build(*grown, reading);
}

Result<std::vector<JawSurface>, ImportFailure> SpecimenFiles::scenery(const SpecimenSource& source, ToothCancel cancel) const {
  const Hash256 kept_as = key("scenery", only(source));
  if (keeps(source)) {
    const auto bytes = files_.read(kept_as);
    auto kept = bytes ? scenery_from_bytes(*bytes) : std::nullopt;
    if (kept) return std::move(*kept);
  }
  auto grown = make_scenery(source, cancel);
  if (grown && !grown->empty() && keeps(source)) files_.keep(kept_as, scenery_bytes(*grown));
  return grown;
}

}  // namespace cusp::ui
