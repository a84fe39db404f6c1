// Finds the functions of a C++ source by their braces: enough to measure how long they are, and not a parser.
#pragma once

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tumble::test {

struct Function {
    std::string head;  // "void f(int a)"
    int line = 0;      // of the start of the head, from 1
    int length = 0;    // lines, from the start of the head to the closing brace
};

inline std::size_t end_of_quoted(const std::string& source, std::size_t start) {
    std::size_t end = start + 1;
    while (end < source.size() && source[end] != source[start]) end += source[end] == '\\' ? 2 : 1;
    return end + 1;
}

// The end of "#define ..." and its continued lines.
inline std::size_t end_of_directive(const std::string& source, std::size_t start) {
    std::size_t end = source.find('\n', start);
    while (end != std::string::npos && source[end - 1] == '\\') end = source.find('\n', end + 1);
    return end;
}

// The end of the comment, literal or directive that starts here, or `start` if none does.
inline std::size_t end_of_text(const std::string& source, std::size_t start) {
    const char before = start > 0 ? source[start - 1] : '\n', here = source[start];
    if (source.compare(start, 2, "//") == 0) return source.find('\n', start);
    if (source.compare(start, 2, "/*") == 0) return source.find("*/", start + 2) + 2;
    if (source.compare(start, 2, "R\"") == 0) {
        const std::size_t open = source.find('(', start);
        const std::string close = ")" + source.substr(start + 2, open - start - 2) + "\"";
        return source.find(close, open) + close.size();
    }
    const bool is_separator_of_digits = std::isalnum(static_cast<unsigned char>(before));
    if (here == '"' || (here == '\'' && !is_separator_of_digits)) return end_of_quoted(source, start);
    return here == '#' && before == '\n' ? end_of_directive(source, start) : start;
}

// The source with blanks in place of comments, literals and directives. Its lines keep their numbers.
inline std::string code_of(std::string source) {
    for (std::size_t i = 0; i < source.size();) {
        const std::size_t end = std::min(end_of_text(source, i), source.size());
        for (std::size_t k = i; k < end; ++k)
            if (source[k] != '\n') source[k] = ' ';
        i = std::max(i + 1, end);
    }
    return source;
}

inline std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \n");
    return first == std::string_view::npos ? "" : text.substr(first, text.find_last_not_of(" \n") - first + 1);
}

// The text behind "template <...>".
inline std::string_view without_template(std::string_view head) {
    if (!head.starts_with("template")) return head;
    int depth = 0;
    for (std::size_t i = 0; i < head.size(); ++i) {
        depth += (head[i] == '<') - (head[i] == '>');
        if (head[i] == '>' && depth == 0) return without_template(trimmed(head.substr(i + 1)));
    }
    return head;
}

// Whether the brace behind the head opens a namespace or a type, which contains functions.
inline bool opens_scope(std::string_view head) {
    constexpr std::array<std::string_view, 7> kKeywords{
        "namespace", "inline namespace", "class", "struct", "union", "enum", "extern"};
    const std::string_view declaration = without_template(head);
    return std::ranges::any_of(kKeywords, [&](std::string_view word) { return declaration.starts_with(word); });
}

inline bool is_function(std::string_view head) {
    return head.find('(') != std::string_view::npos && !head.ends_with('=');
}

class FunctionFinder {
public:
    explicit FunctionFinder(const std::string& source) : code_(code_of(source)) {
        for (std::size_t i = 0; i < code_.size(); ++i) read(i);
    }

    const std::vector<Function>& found() const { return found_; }

private:
    void read(std::size_t i) {
        if (code_[i] == '{') {
            if (depth_ > 0 || !opens_scope(head_before(i)))
                ++depth_;
            else
                start_ = i + 1;
        } else if (code_[i] == '}') {
            if (depth_ == 0 || (--depth_ == 0 && ends_declaration(i))) end_declaration(i);
        } else if (depth_ == 0 && (code_[i] == ';' || is_access(i))) {
            start_ = i + 1;
        }
    }

    std::string_view head_before(std::size_t end) const {
        return trimmed(std::string_view(code_).substr(start_, end - start_));
    }

    // Whether the colon ends "public:" or its like.
    bool is_access(std::size_t i) const {
        const std::string_view head = code_[i] == ':' ? head_before(i) : "";
        return head == "public" || head == "private" || head == "protected";
    }

    // The braces of a member in "X() : member_{1} {" do not.
    bool ends_declaration(std::size_t brace) const {
        const std::size_t next = code_.find_first_not_of(" \n", brace + 1);
        return next == std::string::npos || (code_[next] != '{' && code_[next] != ',');
    }

    void end_declaration(std::size_t brace) {
        const std::size_t first = code_.find_first_not_of(" \n", start_);
        const std::string_view head = head_before(std::min(code_.find('{', start_), brace));
        const auto line_of = [&](std::size_t i) {
            return static_cast<int>(std::count(code_.begin(), code_.begin() + static_cast<std::ptrdiff_t>(i), '\n')) +
                   1;
        };
        if (is_function(head))
            found_.push_back({std::string(head), line_of(first), line_of(brace) - line_of(first) + 1});
        start_ = brace + 1;
    }

    std::string code_;
    std::size_t start_ = 0;  // of the declaration that is read
    int depth_ = 0;          // of braces within a function or a value; 0 in namespaces and types
    std::vector<Function> found_;
};

inline std::vector<Function> functions_of(const std::string& source) { return FunctionFinder(source).found(); }

}  // namespace tumble::test
