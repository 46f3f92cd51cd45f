#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "scenarios/checks/checks.h"
#include "scenarios/format/keys.h"
#include "scenarios/library/library.h"

namespace cusp::scenarios {
namespace {

/// Resolution of lengths in texts: a tenth or a hundredth of a millimetre.
constexpr double kSameMm = 0.005;
/// Share of common words from which one text counts as the other's template.
constexpr double kLikeShare = 0.6;

bool is_digit(char c) noexcept { return c >= '0' && c <= '9'; }

struct Figure {
  double value;
  bool whole;  // without a decimal sign
  bool mm;     // the unit follows, alone or within another
  bool length; // alone
};

/// Whether what follows "mm" makes an area, a volume or a speed of it.
bool makes_another_unit(std::string_view t) noexcept {
  constexpr std::array<std::string_view, 5> ends = {"\xc2\xb2", "\xc2\xb3", "^", "/s", "/min"};
  return std::ranges::any_of(ends, [t](std::string_view end) { return t.starts_with(end); });
}

/// Numbers of a text, with '.' or ',' before their decimals.
std::vector<Figure> figures_of(std::string_view text) {
  std::vector<Figure> out;
  for (std::size_t i = 0; i < text.size();) {
    if (!is_digit(text[i])) {
      ++i;
      continue;
    }
    std::string digits;
    bool whole = true;
    for (; i < text.size(); ++i) {
      const bool decimal = whole && (text[i] == '.' || text[i] == ',') && i + 1 < text.size() && is_digit(text[i + 1]);
      if (!is_digit(text[i]) && !decimal) break;
      digits += decimal ? '.' : text[i];
      whole = whole && !decimal;
    }
    std::size_t unit = i;
    while (text.substr(unit).starts_with(' ')) ++unit;
    for (const std::string_view blank : {"\xc2\xa0", "\xe2\x80\xaf"})  // no-break spaces
      if (text.substr(unit).starts_with(blank)) unit += blank.size();
    double value = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), value);
    const bool mm = text.substr(unit).starts_with("mm");
    out.push_back({value, whole, mm, mm && !makes_another_unit(text.substr(unit + 2))});
  }
  return out;
}

/// The lengths that a target is drawn with.
std::vector<double> drawn_mm(const Scenario& s) {
  std::vector<double> out;
  for (const Outline* o : outlines_of(s.target)) {
    out.push_back(o->depth_mm);
    out.push_back(o->shape == "box" ? o->box_size_mm.x : o->width_mm);
    if (o->shape == "box") out.push_back(o->box_size_mm.y);
  }
  return out;
}
/// Every other length that an exercise's text may name.
std::vector<double> known_mm(const Scenario& s) {
  std::vector<double> out = drawn_mm(s);
  for (const double mm : {s.leeway.floor_mm, s.leeway.side_mm}) out.push_back(mm);
  for (const auto& [face, mm] : s.leeway.faces) out.push_back(mm);
  for (const Outline* o : outlines_of(s.target)) out.push_back(o->corner_radius_mm);
  for (const Bur& bur : s.instruments) {
    out.push_back(2.0 * bur.radius_mm);
    for (const Outline* o : outlines_of(s.target)) out.push_back(o->width_mm - 2.0 * bur.radius_mm);
  }
  return out;
}
bool holds(const std::vector<double>& all, double mm) {
  return std::ranges::any_of(all, [mm](double one) { return std::fabs(one - mm) < kSameMm; });
}

std::set<std::string> words_of(std::string_view text) {
  std::set<std::string> out;
  std::string word;
  for (const char c : text) {
    const bool part = static_cast<unsigned char>(c) >= 0x80 || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    if (part) {
      word += c;
    } else if (!word.empty()) {
      out.insert(std::exchange(word, {}));
    }
  }
  if (!word.empty()) out.insert(word);
  return out;
}

bool alike(const std::string& a, const std::string& b) {
  const std::set<std::string> x = words_of(a), y = words_of(b);
  std::size_t both = 0;
  for (const std::string& word : x) both += y.count(word);
  const std::size_t all = x.size() + y.size() - both;
  return all > 0 && static_cast<double>(both) >= kLikeShare * static_cast<double>(all);
}

bool other_tooth(const SpecimenSource& a, const SpecimenSource& b) {
  return a.generator != b.generator || a.fdi != b.fdi || a.volume != b.volume || a.typodont != b.typodont ||
         a.around != b.around || a.lesions != b.lesions;
}
bool other_target(const Region& a, const Region& b) {
  if (a.kind != RegionKind::outline || b.kind != RegionKind::outline) return a != b;
  const Outline &c = a.outline, &d = b.outline;
  return c.shape != d.shape || c.paths != d.paths || c.depth_mm != d.depth_mm || c.width_mm != d.width_mm ||
         c.box_size_mm != d.box_size_mm;
}

class TextCheck {
 public:
  TextCheck(const Scenario& scenario, std::span<const Scenario> patterns) : s_(scenario), patterns_(patterns) {}

  std::vector<Finding> run() {
    for (const auto& [language, text] : s_.title) {
      check("/title", language, text, [](const Scenario& p) -> const LocalText& { return p.title; });
      tooth(language, text);
    }
    for (const auto& [language, text] : s_.briefing) {
      check("/briefing", language, text, [](const Scenario& p) -> const LocalText& { return p.briefing; });
      figures(language, text);
    }
    return std::move(out_);
  }

 private:
  template <class Of>
  void check(const char* path, const std::string& language, const std::string& text, Of of) {
    bool own = false, others = false;
    for (const Scenario& p : patterns_) {
      const auto same = of(p).find(language);
      if (same == of(p).end() || same->second != text) continue;
      const bool differs = other_tooth(p.specimen, s_.specimen) || other_target(p.target, s_.target);
      (differs ? others : own) = true;
    }
    if (others && !own) out_.push_back({Severity::warning, std::string(path) + "/" + language, "text_of_template", {}, language});
  }

  /// A title's whole numbers are teeth where FDI has them; a briefing's may be minutes.
  void tooth(const std::string& language, const std::string& text) {
    const int fdi = s_.specimen.tooth_number();
    if (fdi == 0) return;
    std::optional<int> wrong;
    for (const Figure& f : figures_of(text)) {
      if (!f.whole || f.mm || f.value > 48 || !is_fdi(static_cast<int>(f.value))) continue;
      if (static_cast<int>(f.value) == fdi) return;
      wrong = static_cast<int>(f.value);
    }
    if (!wrong) return;
    out_.push_back({Severity::warning, "/title/" + language, "text_other_tooth",
                    {{"value", static_cast<double>(*wrong)}, {"limit", static_cast<double>(fdi)}}, language});
  }

  void figures(const std::string& language, const std::string& text) {
    const std::vector<double> drawn = drawn_mm(s_), known = known_mm(s_);
    std::optional<double> foreign, left;
    bool named = false;
    for (const Figure& f : figures_of(text)) {
      if (!f.length) continue;
      named = named || holds(drawn, f.value);
      if (holds(known, f.value)) continue;
      if (!foreign) foreign = f.value;
      const auto has = [&](const Scenario& p) {
        const auto same = p.briefing.find(language);
        if (same == p.briefing.end() || !alike(same->second, text)) return false;
        return holds(drawn_mm(p), f.value) || holds({p.leeway.floor_mm, p.leeway.side_mm}, f.value);
      };
      if (!left && std::ranges::any_of(patterns_, has)) left = f.value;
    }
    // A length that its template had, or lengths of which none is the target's.
    if (!left && foreign && !named) left = foreign;
    if (left) out_.push_back({Severity::warning, "/briefing/" + language, "text_figure", {{"value", *left}}, language});
  }

  const Scenario& s_;
  std::span<const Scenario> patterns_;
  std::vector<Finding> out_;
};

}  // namespace

std::vector<Finding> check_texts(const Scenario& scenario, std::span<const Scenario> patterns) {
  return TextCheck(scenario, patterns).run();
}

const std::vector<Scenario>& library_patterns() {
  static const std::vector<Scenario> all = [] {
    std::vector<Scenario> out;
    for (const std::string_view key : builtin_scenarios())
      if (auto scenario = load_builtin(key)) out.push_back(std::move(*scenario));
    return out;
  }();
  return all;
}

}  // namespace cusp::scenarios
