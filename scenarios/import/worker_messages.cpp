#include "scenarios/import/worker_messages.h"

#include <initializer_list>

namespace cusp::scenarios {
namespace {

constexpr std::string_view kMark = "cusp-import\t";

std::string escaped(std::string_view t) {
  std::string out;
  for (const char c : t) {
    if (c == '\\') out += "\\\\";
    else if (c == '\n') out += "\\n";
    else if (c == '\t') out += "\\t";
    else out += c;
  }
  return out;
}

/// Reads fields in order; after the first that does not parse, all fail.
class Reader {
 public:
  template <class Fields>
  explicit Reader(const Fields& fields) {
    for (const auto& w : fields) fields_.emplace_back(w);
  }
  std::string_view text() {
    if (at_ >= fields_.size()) ok_ = false;
    return ok_ ? fields_[at_++] : std::string_view{};
  }
  template <class Number>
  Number number() {
    const auto n = number_of<Number>(text());
    if (!n) ok_ = false;
    return n.value_or(Number{});
  }
  bool flag() { return number<unsigned>() != 0; }
  Vec3 vec() {
    Vec3 v;
    for (int i = 0; i < 3; ++i) v[i] = number<double>();
    return v;
  }
  Tissue tissue() {
    const auto code = number<unsigned>();
    if (!is_tissue_code(code)) ok_ = false;
    return ok_ ? static_cast<Tissue>(code) : Tissue::empty;
  }
  UpAxis up() {
    const auto n = number<unsigned>();
    if (n >= kUpAxisKeys.size()) ok_ = false;
    return ok_ ? static_cast<UpAxis>(n) : UpAxis::z;
  }
  VolumeLimits limits() {
    VolumeLimits out;
    out.max_edge_voxels = number<int>();
    out.max_voxels = number<std::size_t>();
    out.min_voxel_mm = number<double>();
    out.max_voxel_mm = number<double>();
    return out;
  }
  bool ok() const { return ok_; }
  bool more() const { return ok_ && at_ < fields_.size(); }
  bool ended() const { return ok_ && at_ == fields_.size(); }

 private:
  std::vector<std::string_view> fields_;
  std::size_t at_ = 0;
  bool ok_ = true;
};

void add(std::vector<std::string>& to, Vec3 v) {
  for (int i = 0; i < 3; ++i) to.push_back(text_of(v[i]));
}
void add(std::vector<std::string>& to, const VolumeLimits& limits) {
  to.insert(to.end(), {text_of(limits.max_edge_voxels), text_of(limits.max_voxels), text_of(limits.min_voxel_mm),
                       text_of(limits.max_voxel_mm)});
}
std::string code_of(Tissue tissue) { return text_of(static_cast<unsigned>(tissue)); }

}  // namespace

std::string message_line(const std::vector<std::string>& fields) {
  std::string line(kMark);
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (i > 0) line += '\t';
    line += escaped(fields[i]);
  }
  return line + '\n';
}

std::optional<std::vector<std::string>> fields_of_line(std::string_view t) {
  if (!t.starts_with(kMark)) return std::nullopt;
  t.remove_prefix(kMark.size());
  std::vector<std::string> out(1);
  for (std::size_t i = 0; i < t.size(); ++i) {
    if (t[i] == '\t') {
      out.emplace_back();
    } else if (t[i] == '\\' && i + 1 < t.size()) {
      ++i;
      out.back() += t[i] == 'n' ? '\n' : t[i] == 't' ? '\t' : t[i];
    } else {
      out.back() += t[i];
    }
  }
  return out;
}

std::vector<std::string> arguments_of(const MeshImport& job, const std::filesystem::path& out) {
  std::vector<std::string> a = {"mesh",
                                std::filesystem::absolute(job.path).string(),
                                out.string(),
                                text_of(job.unit_mm),
                                text_of(job.voxel_mm),
                                text_of(static_cast<unsigned>(job.up)),
                                text_of(job.mend_holes_mm.value_or(-1.0)),
                                text_of(static_cast<unsigned>(job.precedence))};
  add(a, job.limits);
  a.push_back(text_of(job.more.size()));
  for (const std::filesystem::path& file : job.more) a.push_back(std::filesystem::absolute(file).string());
  for (const auto& [name, tissue] : job.tissues) a.insert(a.end(), {name, code_of(tissue)});
  return a;
}

std::optional<MeshImport> mesh_job(std::span<const std::string_view> arguments, std::filesystem::path& out) {
  Reader r(arguments);
  if (r.text() != "mesh") return std::nullopt;
  MeshImport job;
  job.path = r.text();
  out = r.text();
  job.unit_mm = r.number<double>();
  job.voxel_mm = r.number<double>();
  job.up = r.up();
  if (const double mend = r.number<double>(); !(mend < 0.0)) job.mend_holes_mm = mend;
  const auto precedence = r.number<unsigned>();
  if (precedence >= kPrecedenceKeys.size()) return std::nullopt;
  job.precedence = static_cast<PartPrecedence>(precedence);
  job.limits = r.limits();
  for (auto n = r.number<std::size_t>(); n > 0 && r.more(); --n) job.more.emplace_back(r.text());
  while (r.more()) {
    const std::string name(r.text());
    job.tissues.emplace_back(name, r.tissue());
  }
  return r.ended() ? std::optional(std::move(job)) : std::nullopt;
}

std::vector<std::string> arguments_of(const ImageImport& job, const std::filesystem::path& out) {
  const ImageTissues& t = job.tissues;
  std::vector<std::string> a = {"image",
                                std::filesystem::absolute(job.path).string(),
                                out.string(),
                                text_of(t.unit_mm),
                                text_of(t.voxel_mm.value_or(0.0)),
                                text_of(static_cast<unsigned>(t.up)),
                                t.largest_component ? "1" : "0",
                                code_of(t.hollows.value_or(Tissue::empty))};
  add(a, job.limits);
  for (const auto& [value, tissue] : t.labels) a.insert(a.end(), {"label", text_of(value), code_of(tissue)});
  for (const auto& [from, tissue] : t.thresholds) a.insert(a.end(), {"from", text_of(from), code_of(tissue)});
  return a;
}

std::optional<ImageImport> image_job(std::span<const std::string_view> arguments, std::filesystem::path& out) {
  Reader r(arguments);
  if (r.text() != "image") return std::nullopt;
  ImageImport job;
  ImageTissues& t = job.tissues;
  job.path = r.text();
  out = r.text();
  t.unit_mm = r.number<double>();
  if (const double voxel = r.number<double>(); voxel != 0.0) t.voxel_mm = voxel;
  t.up = r.up();
  t.largest_component = r.flag();
  if (const Tissue hollows = r.tissue(); hollows != Tissue::empty) t.hollows = hollows;
  job.limits = r.limits();
  while (r.more()) {
    const std::string_view kind = r.text();
    if (kind == "label") {
      const auto value = r.number<std::uint32_t>();
      t.labels.emplace_back(value, r.tissue());
    } else if (kind == "from") {
      const auto from = r.number<double>();
      t.thresholds.emplace_back(from, r.tissue());
    } else {
      return std::nullopt;
    }
  }
  return r.ended() ? std::optional(std::move(job)) : std::nullopt;
}

std::vector<std::string> message_of(const MeshInfo& mesh) {
  std::vector<std::string> w = {"mesh", mesh.name, text_of(mesh.triangles)};
  add(w, mesh.low);
  add(w, mesh.high);
  w.insert(w.end(), {text_of(mesh.volume), mesh.closed ? "1" : "0", mesh.oriented ? "1" : "0", text_of(mesh.gap_count)});
  add(w, mesh.turned_at);
  w.push_back(text_of(mesh.left_open));
  for (const MeshGap& gap : mesh.gaps) {
    w.insert(w.end(), {text_of(gap.edges), text_of(gap.length)});
    add(w, gap.low);
    add(w, gap.high);
  }
  return w;
}

std::optional<MeshInfo> mesh_info_of(const std::vector<std::string>& fields) {
  Reader r(fields);
  if (r.text() != "mesh") return std::nullopt;
  MeshInfo m;
  m.name = r.text();
  m.triangles = r.number<std::size_t>();
  m.low = r.vec();
  m.high = r.vec();
  m.volume = r.number<double>();
  m.closed = r.flag();
  m.oriented = r.flag();
  m.gap_count = r.number<std::size_t>();
  m.turned_at = r.vec();
  m.left_open = r.number<double>();
  while (r.more()) {
    MeshGap gap;
    gap.edges = r.number<std::size_t>();
    gap.length = r.number<double>();
    gap.low = r.vec();
    gap.high = r.vec();
    m.gaps.push_back(gap);
  }
  return r.ended() ? std::optional(std::move(m)) : std::nullopt;
}

std::vector<std::string> message_of(const ImageInfo& image) {
  std::vector<std::string> w = {"image", image.specimen ? "1" : "0", text_of(static_cast<unsigned>(image.kind))};
  for (int i = 0; i < 3; ++i) w.push_back(text_of(image.size[i]));
  add(w, image.spacing_mm);
  w.insert(w.end(), {image.spacing_known ? "1" : "0", text_of(image.turned_degrees), text_of(image.low), text_of(image.high),
                     text_of(image.series), text_of(image.slices)});
  for (const auto& [value, count] : image.values) w.insert(w.end(), {text_of(value), text_of(count)});
  return w;
}

std::optional<ImageInfo> image_info_of(const std::vector<std::string>& fields) {
  Reader r(fields);
  if (r.text() != "image") return std::nullopt;
  ImageInfo out;
  out.specimen = r.flag();
  const auto kind = r.number<unsigned>();
  if (kind >= kImageKindKeys.size()) return std::nullopt;
  out.kind = static_cast<ImageKind>(kind);
  for (int i = 0; i < 3; ++i) out.size[i] = r.number<int>();
  out.spacing_mm = r.vec();
  out.spacing_known = r.flag();
  out.turned_degrees = r.number<double>();
  out.low = r.number<double>();
  out.high = r.number<double>();
  out.series = r.number<std::size_t>();
  out.slices = r.number<std::size_t>();
  while (r.more()) {
    const auto value = r.number<std::uint32_t>();
    out.values.emplace_back(value, r.number<std::size_t>());
  }
  return r.ended() ? std::optional(std::move(out)) : std::nullopt;
}

std::vector<std::string> message_of(const ImportRemark& remark) {
  std::vector<std::string> w = {"remark", std::string(key_of(remark.code)), remark.subject, remark.other};
  for (const double n : remark.numbers) w.push_back(text_of(n));
  return w;
}

std::optional<ImportRemark> remark_of(const std::vector<std::string>& fields) {
  Reader r(fields);
  if (r.text() != "remark") return std::nullopt;
  const auto code = remark_from_key(r.text());
  if (!code) return std::nullopt;
  ImportRemark out{*code};
  out.subject = r.text();
  out.other = r.text();
  while (r.more()) out.numbers.push_back(r.number<double>());
  return r.ended() ? std::optional(std::move(out)) : std::nullopt;
}

}  // namespace cusp::scenarios
