// Diagnostics are collected with JSON pointers, located in the text once, at the end, and printed with their line and a
// caret.
#include "scene/json/diagnostics.hpp"

#include "scene/json/problem_codes.hpp"

#include <algorithm>
#include <tuple>

#include "scene/json/locate.hpp"
#include "scene/json/pointer.hpp"

namespace tumble {

namespace {

// Of a long line, this much is shown on each side of the caret, in bytes.
constexpr std::size_t kExcerptSide = 60;

bool is_continuation_byte(char c) { return (static_cast<unsigned char>(c) & 0xC0u) == 0x80u; }

// True for bytes that a terminal may interpret as a command.
bool is_control_byte(char c) { return (static_cast<unsigned char>(c) < 0x20u && c != '\t') || c == '\x7f'; }

struct Excerpt {
    std::string line;
    std::string caret;
};

Excerpt make_excerpt(const std::string& line, int column) {
    const std::size_t at = std::min(static_cast<std::size_t>(std::max(column - 1, 0)), line.size());
    std::size_t from = at > kExcerptSide ? at - kExcerptSide : 0;
    std::size_t to = std::min(line.size(), at + kExcerptSide);
    while (from > 0 && is_continuation_byte(line[from])) --from;
    while (to < line.size() && is_continuation_byte(line[to])) ++to;
    Excerpt excerpt{line.substr(from, to - from), ""};
    std::ranges::replace_if(excerpt.line, is_control_byte, '?');
    for (std::size_t i = from; i < at; ++i) {
        if (!is_continuation_byte(line[i])) excerpt.caret += line[i] == '\t' ? '\t' : ' ';
    }
    if (from > 0) {
        excerpt.line = "..." + excerpt.line;
        excerpt.caret = "   " + excerpt.caret;
    }
    if (to < line.size()) excerpt.line += "...";
    excerpt.caret += '^';
    return excerpt;
}

std::string join(const std::vector<Diagnostic>& diagnostics) {
    std::string text;
    for (const Diagnostic& diagnostic : diagnostics) {
        if (!text.empty()) text += '\n';
        text += to_string(diagnostic);
    }
    return text;
}

}  // namespace

std::string to_string(const Diagnostic& d) {
    std::string text = d.file;
    if (d.line > 0) text += ':' + std::to_string(d.line) + ':' + std::to_string(d.column);
    if (!d.pointer.empty()) text += ": " + d.pointer;
    text += d.severity == Diagnostic::Severity::warning ? ": warning: " + d.message : ": " + d.message;
    if (!d.code.empty()) text += " [" + d.code + "]";
    if (d.line > 0) {
        const Excerpt excerpt = make_excerpt(d.source_line, d.column);
        text += "\n  " + excerpt.line + "\n  " + excerpt.caret;
    }
    if (!d.hint.empty()) text += "\n  hint: " + d.hint;
    for (const std::string& location : d.included_by) text += "\n  included by " + location;
    return text;
}

SceneError::SceneError(std::vector<Diagnostic> all) : std::runtime_error(join(all)), diagnostics(std::move(all)) {}

namespace scene {

void Diagnostics::add_origin(std::string pointer, std::string origin) {
    origins_.emplace_back(std::move(pointer), std::move(origin));
}

void Diagnostics::error(std::string pointer, std::string message, std::string hint, At at) {
    if (errors_.size() == kMaxDiagnostics) {
        overflowed_ = true;
        return;
    }
    errors_.push_back({std::move(pointer),
                       std::move(message),
                       std::move(hint),
                       at,
                       std::string_view::npos,
                       std::string_view::npos,
                       {}});
}

void Diagnostics::warning(std::string_view code, std::string pointer, std::string message, std::string hint) {
    if (warnings_.size() == kMaxDiagnostics) return;
    warnings_.push_back({std::move(pointer), std::move(message), std::move(hint), At::value, std::string_view::npos,
                         std::string_view::npos, code});
}

void Diagnostics::error_in_text(std::string pointer, std::size_t inside, std::string message, std::string hint) {
    error(std::move(pointer), std::move(message), std::move(hint));
    if (!overflowed_) errors_.back().inside = inside;
}

void Diagnostics::error_at_offset(std::size_t offset, std::string message, std::string hint, std::string_view code) {
    errors_.push_back({"", std::move(message), std::move(hint), At::value, offset, std::string_view::npos, code});
}

bool Diagnostics::has_errors_in(std::string_view pointer) const {
    return overflowed_ ||
           std::ranges::any_of(errors_, [&](const Entry& entry) { return is_within(entry.pointer, pointer); }) ||
           std::ranges::any_of(adopted_errors_,
                               [&](const Adopted& entry) { return is_within(entry.include, pointer); });
}

void Diagnostics::adopt(const std::vector<Diagnostic>& found, const std::string& include) {
    for (const Diagnostic& diagnostic : found)
        (diagnostic.severity == Diagnostic::Severity::error ? adopted_errors_ : adopted_warnings_)
            .push_back({diagnostic, include});
}

std::string Diagnostics::name_of(const std::string& pointer) const {
    const std::optional<IncludedLocation> included = included_.find(pointer);
    return included ? included->name : pointer;
}

Diagnostic Diagnostics::locate(const Entry& entry, Diagnostic::Severity severity) const {
    if (const std::optional<IncludedLocation> included = included_.find(entry.pointer))
        return locate({.pointer = included->include,
                       .message = included->name + ": " + entry.message,
                       .hint = entry.hint,
                       .code = entry.code},
                      severity);
    Diagnostic d{severity, file_, 0, 0, entry.pointer, entry.message, "", entry.hint};
    d.code = entry.code.empty() ? code_of_error(entry.pointer) : entry.code;
    for (const auto& [pointer, origin] : origins_) {
        if (!is_within(entry.pointer, pointer)) continue;
        d.file = origin;
        d.is_of_argument = true;
        if (!d.pointer.starts_with('/')) d.pointer.clear();  // an override without a pointer
        return d;
    }
    if (text_.empty()) return d;
    const bool known = entry.offset != std::string_view::npos;
    std::size_t offset =
        std::min(known ? entry.offset : find_offset(text_, entry.pointer, entry.at == At::key), text_.size());
    if (entry.inside != std::string_view::npos) offset = offset_in_string(text_, offset, entry.inside);
    const std::size_t newline = text_.substr(0, offset).rfind('\n');
    const std::size_t start = newline == std::string_view::npos ? 0 : newline + 1;
    const std::string_view rest = text_.substr(start);
    d.line = 1 + static_cast<int>(std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(start), '\n'));
    d.column = 1 + static_cast<int>(offset - start);
    d.source_line = rest.substr(0, std::min(rest.find_first_of("\r\n"), rest.size()));
    return d;
}

std::vector<Diagnostic> Diagnostics::locate_all(const std::vector<Entry>& entries, const std::vector<Adopted>& adopted,
                                                Diagnostic::Severity severity) const {
    std::vector<Diagnostic> located;
    for (const Entry& entry : entries) located.push_back(locate(entry, severity));
    std::stable_sort(located.begin(), located.end(), [](const Diagnostic& a, const Diagnostic& b) {
        return std::tie(a.line, a.column) < std::tie(b.line, b.column);
    });
    for (const Adopted& entry : adopted) {
        if (located.size() >= kMaxDiagnostics) break;
        const Diagnostic by = locate({.pointer = entry.include, .message = {}, .hint = {}}, severity);
        located.push_back(entry.diagnostic);
        located.back().included_by.push_back(
            by.line > 0 ? by.file + ':' + std::to_string(by.line) + ':' + std::to_string(by.column) : by.file);
    }
    return located;
}

void Diagnostics::finish(std::vector<Diagnostic>* warnings) {
    if (has_errors()) {
        std::vector<Diagnostic> located = locate_all(errors_, adopted_errors_, Diagnostic::Severity::error);
        if (overflowed_ || errors_.size() + adopted_errors_.size() > kMaxDiagnostics) {
            const std::string more = "there are more errors; these are the first " + std::to_string(kMaxDiagnostics);
            std::string& hint = located.back().hint;
            hint = hint.empty() ? more : hint + "; " + more;
        }
        throw SceneError(std::move(located));
    }
    if (warnings == nullptr) return;
    const std::vector<Diagnostic> located = locate_all(warnings_, adopted_warnings_, Diagnostic::Severity::warning);
    warnings->insert(warnings->end(), located.begin(), located.end());
}

}  // namespace scene

}  // namespace tumble
