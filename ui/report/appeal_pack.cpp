#include "ui/report/appeal_pack.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QTemporaryDir>
#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>

#include "scenarios/import/nrrd.h"
#include "scenarios/library/tar.h"
#include "storage/export/csv.h"
#include "storage/records/statement_rows.h"
#include "ui/report/report_pdf.h"
#include "ui/report/report_text.h"
#include "ui/session/file_bytes.h"
#include "ui/text/exchange_text.h"
#include "ui/widgets/save_bytes.h"

namespace cusp::ui {
namespace {

namespace fs = std::filesystem;

struct PackText {
  Q_DECLARE_TR_FUNCTIONS(cusp::ui::AppealPack)
};

constexpr int kPictureSidePx = 1200;
constexpr const char* kDescription = "pack.json";
constexpr const char* kSignature = "pack.sig";
constexpr const char* kRecords = "records.db";
constexpr std::array kContents = {kRecords, "log.csv", "report.pdf", "report.json", "tooth.png", "tooth.nrrd"};
constexpr std::size_t kMostEntries = kContents.size() + 2;

/// Of a pack's own records, which hold one attempt.
constexpr Actor kReader{.id = {}, .role = Role::instructor};

struct Content {
  std::string name, bytes;
};

Message no_room(const QString& why) {
  return {PackText::tr("The pack cannot be written to the temporary folder: %1.").arg(why), PackText::tr("Nothing was changed.")};
}
Message too_long() { return {PackText::tr("The attempt is too long for an appeal pack."), {}}; }
Message no_pack(const fs::path& file) {
  return {PackText::tr("%1 is no appeal pack.").arg(QString::fromStdString(file.filename().string())),
          PackText::tr("It may have been cut off on its way. Ask for it once more.")};
}
Message cannot_write_pack(const QString& file, const std::string& why) {
  return {PackText::tr("%1 cannot be written: %2.").arg(file, QString::fromStdString(why)), PackText::tr("The attempt and its grade are kept.")};
}

/// Names the file and the system's reason where a failure means the file, not the records.
Message describe_pack_failure(const StorageFailure& f, const fs::path& file) {
  const QString shown = QString::fromStdString(file.string());
  if (f.code == StorageError::duplicate) return describe_exchange_failure(f, shown);
  std::error_code ignored;
  if (f.detail == "folder") return cannot_write_pack(shown, std::generic_category().message(fs::exists(f.where, ignored) ? ENOTDIR : ENOENT));
  return f.where == file.string() ? cannot_write_pack(shown, f.detail) : describe(f);
}

/// One of the pack's files.
Result<void, Message> write_content(const fs::path& path, std::string_view bytes) {
  const auto written = save_bytes(QString::fromStdString(path.string()), QByteArray::fromRawData(bytes.data(), static_cast<qsizetype>(bytes.size())));
  if (!written) return std::unexpected(no_room(written.error()));
  return {};
}

Stored<std::unique_ptr<Store>> open_extract(const fs::path& file) {
  StoreOptions options;
  options.database.access = DatabaseOptions::Access::read_only;
  options.mark_interrupted = false;
  return Store::open(file, options);
}

/// Names as the extract has them: it does not hold that of a candidate.
std::string text_of(const std::vector<AuditEntry>& log, Store& extract) {
  const NameOf name_of = [&](const Uuid& id) {
    const auto account = extract.accounts.find(UserId{id});
    return account ? account->name : std::string();
  };
  std::string out = audit_csv_head();
  for (const AuditEntry& entry : log) out += audit_csv_line(entry, name_of);
  return out;
}

/// The report's files, from the extract that goes out with them. A tooth that cannot be drawn leaves its picture out.
Result<void, Message> write_report(const fs::path& folder, Store& store, SessionId id) {
  auto result = open_result(store, id);
  if (!result) return std::unexpected(describe(result.error()));
  const auto session = store.sessions.find(id);
  if (!session) return std::unexpected(describe(session.error()));
  const auto student = store.accounts.find(session->student);
  if (!student) return std::unexpected(describe(student.error()));
  const ReportData data = gather_report(*result, &store, &kReader);
  if (data.unread) return std::unexpected(describe(*data.unread));
  const DrawnTooth tooth = draw_report_tooth(*result, order_for_paper(data, kPictureSidePx));
  if (const auto pdf = write_report_pdf(folder / "report.pdf", data, tooth); !pdf) return std::unexpected(no_room(QString::fromStdString(pdf.error().detail)));
  if (auto written = write_content(folder / "report.json", report_text(data.result, store, *student)); !written) return written;
  if (tooth) {
    QByteArray png;
    QBuffer buffer(&png);
    buffer.open(QIODevice::WriteOnly);
    if (!tooth->image.save(&buffer, "PNG")) return std::unexpected(no_room(u"PNG"_qs));
    if (auto written = write_content(folder / "tooth.png", png.toStdString()); !written) return written;
  }
  if (const auto written = write_nrrd(result->volume->dense(), folder / "tooth.nrrd"); !written) return std::unexpected(describe(written.error()));
  return {};
}

StudentNamed naming(const Session& session) {
  return session.kind == SessionKind::assessment ? StudentNamed::by_candidate_number : StudentNamed::by_name;
}

Result<void, Message> fill(Store& store, const Actor& actor, SessionId id, const fs::path& folder) {
  const auto session = store.sessions.find(id);
  if (!session) return std::unexpected(describe(session.error()));
  if (auto done = extract_session(store.context(), actor, id, naming(*session), folder / kRecords); !done) return std::unexpected(describe(done.error()));
  auto extract = open_extract(folder / kRecords);
  if (!extract) return std::unexpected(describe(extract.error()));
  const auto log = log_about(store.context(), actor, id);
  if (!log) return std::unexpected(describe(log.error()));
  if (auto written = write_content(folder / "log.csv", text_of(*log, **extract)); !written) return written;
  return write_report(folder, **extract, id);
}

std::vector<PackFile> hashes_of(const std::vector<Content>& contents) {
  std::vector<PackFile> out;
  for (const Content& content : contents) out.push_back({content.name, storage::blake2b_256(std::string_view(content.bytes))});
  return out;
}

/// Names of what differs between the signed list and what lies in the archive.
std::vector<std::string> compare(const PackDescription& description, const std::vector<TarEntry>& entries) {
  std::vector<std::string> out;
  for (const PackFile& file : description.files) {
    const auto entry = std::ranges::find(entries, file.name, &TarEntry::name);
    if (entry == entries.end() || storage::blake2b_256(entry->data) != file.hash) out.push_back(file.name);
  }
  for (const TarEntry& entry : entries) {
    const bool own = entry.name == kDescription || entry.name == kSignature;
    if (!own && std::ranges::find(description.files, entry.name, &PackFile::name) == description.files.end()) out.push_back(entry.name);
  }
  return out;
}

/// Chain, statements and result of the unpacked records.
Result<void, Message> read_records(OpenedPack& pack) {
  auto store = open_extract(pack.records);
  if (!store) return std::unexpected(describe(store.error()));
  const SessionId session = pack.checked.description.session;
  auto chain = verify_session((*store)->context(), session);
  if (!chain) return std::unexpected(describe(chain.error()));
  pack.links = chain->links;
  pack.findings = std::move(chain->findings);
  auto statements = check_statements((*store)->database());
  if (!statements) return std::unexpected(describe(statements.error()));
  pack.findings.insert(pack.findings.end(), statements->begin(), statements->end());
  auto result = open_result(**store, session);
  if (!result) return std::unexpected(describe(result.error()));
  pack.result = std::move(*result);
  pack.report = gather_report(pack.result, store->get(), &kReader);
  pack.report.alone = true;
  return {};
}

}  // namespace

Result<void, Message> write_appeal_pack(Store& store, const Actor& actor, SessionId session, const fs::path& file) {
  std::error_code unknown;
  if (fs::exists(file, unknown)) return std::unexpected(describe_pack_failure({StorageError::duplicate, file.string(), {}}, file));
  const QTemporaryDir folder;
  if (!folder.isValid()) return std::unexpected(no_room(folder.errorString()));
  const fs::path in = folder.path().toStdString();
  if (auto filled = fill(store, actor, session, in); !filled) return filled;
  std::vector<Content> contents;
  for (const char* name : kContents) {
    auto bytes = text_of_file(in / name, kMaxPackBytes);
    if (!bytes && bytes.error().code == StorageError::not_found) continue;  // the picture of a tooth that cannot be drawn
    if (!bytes) return std::unexpected(bytes.error().code == StorageError::file_too_large ? too_long() : no_room(QString::fromStdString(bytes.error().detail)));
    contents.push_back({name, std::move(*bytes)});
  }
  const auto signed_pack = sign_pack(store.context(), actor, session, hashes_of(contents));
  if (!signed_pack) return std::unexpected(describe(signed_pack.error()));
  std::vector<TarEntry> entries = {{kDescription, signed_pack->description}, {kSignature, signed_pack->signature}};
  for (const Content& content : contents) entries.push_back({content.name, content.bytes});
  const std::string archive = write_tar(entries);
  if (archive.size() > kMaxPackBytes) return std::unexpected(too_long());
  const auto given_out = give_out_pack(store.context(), actor, session, archive, file);
  if (!given_out) return std::unexpected(describe_pack_failure(given_out.error(), file));
  return {};
}

Result<OpenedPack, Message> open_appeal_pack(const fs::path& file, Store* here) {
  const auto archive = text_of_file(file, kMaxPackBytes);
  if (!archive) {
    return std::unexpected(Message{PackText::tr("%1 cannot be read.").arg(QString::fromStdString(file.string())), {}});
  }
  const auto entries = read_tar(*archive, kMostEntries);
  if (!entries) return std::unexpected(no_pack(file));
  const auto entry = [&](const char* name) {
    const auto found = std::ranges::find(*entries, name, &TarEntry::name);
    return found == entries->end() ? std::string_view() : found->data;
  };
  auto checked = check_pack({std::string(entry(kDescription)), std::string(entry(kSignature))});
  if (!checked || entry(kRecords).empty()) return std::unexpected(no_pack(file));
  OpenedPack pack{.checked = std::move(*checked)};
  if (here != nullptr) {
    const auto signer = signer_of(here->context(), pack.checked);
    if (!signer) return std::unexpected(describe(signer.error()));
    pack.signer = *signer;
  }
  pack.differing = compare(pack.checked.description, *entries);
  const auto folder = std::make_shared<const QTemporaryDir>();
  pack.records = fs::path(folder->path().toStdString()) / kRecords;
  if (!folder->isValid()) return std::unexpected(no_room(folder->errorString()));
  if (auto written = write_content(pack.records, entry(kRecords)); !written) return std::unexpected(written.error());
  pack.folder = folder;
  const bool signed_so = std::ranges::find(pack.differing, std::string(kRecords)) == pack.differing.end();
  // SQLite may refuse what nobody has signed: its message would hide that the file differs.
  const auto read = read_records(pack);
  if (!read && signed_so) return std::unexpected(read.error());
  pack.readable = read.has_value();
  return pack;
}

Result<ReplayProof, Message> prove_pack(const OpenedPack& pack) {
  auto store = open_extract(pack.records);
  if (!store) return std::unexpected(describe(store.error()));
  auto proof = prove_session(**store, pack.checked.description.session);
  if (!proof) return std::unexpected(describe(proof.error()));
  return std::move(*proof);
}

}  // namespace cusp::ui
