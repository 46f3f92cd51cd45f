#include "ui/text/sentences.h"

#include "scenarios/teeth/own_tissues.h"
#include "ui/modules.h"
#include "ui/text/language.h"
#include "ui/text/text.h"

namespace cusp::ui {

QString local(const LocalText& texts) {
  const std::string code = current_language().toStdString();
  if (const auto it = texts.find(code); it != texts.end()) return text(it->second);
  if (const auto it = texts.find("en"); it != texts.end()) return text(it->second);
  return texts.empty() ? QString() : text(texts.begin()->second);
}

QString role_name(Role role) {
  switch (role) {
    case Role::student: return Words::tr("Student");
    case Role::instructor: return Words::tr("Teacher");
    case Role::administrator: return Words::tr("Administrator");
  }
  return {};
}

QString state_name(SessionState state) {
  switch (state) {
    case SessionState::running: return Words::tr("Running");
    case SessionState::interrupted: return Words::tr("Interrupted");
    case SessionState::finished: return Words::tr("Not graded");
    case SessionState::graded: return Words::tr("Graded");
    case SessionState::closed: return Words::tr("Closed");
  }
  return {};
}

QString kind_name(SessionKind kind) {
  switch (kind) {
    case SessionKind::practice: return Words::tr("Practice");
    case SessionKind::assessment: return Words::tr("Assessment");
    case SessionKind::try_it: return Words::tr("Try it");
    case SessionKind::try_out: return Words::tr("Try-out");
  }
  return {};
}

QString device_name(const std::string& device_class) {
  if (device_class == "pointer") return Words::tr("Mouse and keys");
  if (device_class == "falcon") return QStringLiteral("Falcon");
  if (device_class == "emulated-falcon") return Words::tr("Emulated Falcon");
  if (device_class == "inverse3") return QStringLiteral("Inverse3");
  if (device_class == "scripted") return Words::tr("Scripted hand");
  return text(device_class);
}

QString tissue_name(Tissue tissue) {
  switch (tissue) {
    case Tissue::empty: return Words::tr("Nothing");
    case Tissue::enamel: return Words::tr("Enamel");
    case Tissue::dentine: return Words::tr("Dentine");
    case Tissue::carious_dentine: return Words::tr("Decay");
    case Tissue::cementum: return Words::tr("Cementum");
    case Tissue::pulp: return Words::tr("Pulp");
    case Tissue::bone: return Words::tr("Bone");
    case Tissue::gingiva: return Words::tr("Gingiva");
    case Tissue::ligament: return Words::tr("Ligament");
    case Tissue::amalgam: return Words::tr("Amalgam");
    case Tissue::composite: return Words::tr("Composite");
    case Tissue::plastic: return Words::tr("Plastic");
    case Tissue::carious_enamel: return Words::tr("Decayed enamel");
  }
  if (tissue == kNeighbourEnamel) return Words::tr("Neighbour enamel");
  if (tissue == kNeighbourDentine) return Words::tr("Neighbour dentine");
  if (tissue == kFirmCariousDentine) return Words::tr("Firm decay");
  return Words::tr("Material %1").arg(static_cast<int>(tissue) - 15);
}

}  // namespace cusp::ui
