#include "debug/check.hpp"

#include <cstdio>
#include <cstdlib>
#include <string>

namespace tumble::debug {

namespace {

std::string text_of(const Shown& shown) {
    char text[32];
    switch (shown.kind) {
        case Shown::Kind::number: std::snprintf(text, sizeof text, "%.17g", shown.number); return text;
        case Shown::Kind::integer: return std::to_string(shown.integer);
        case Shown::Kind::truth: return shown.integer ? "true" : "false";
        case Shown::Kind::other: break;
    }
    return "(not a number)";
}

}  // namespace

void fail_check(const char* expression, const char* file, int line, const Outcome& outcome) {
    std::string values = text_of(outcome.left);
    if (*outcome.comparison) values += std::string(" ") + outcome.comparison + " " + text_of(outcome.right);
    std::fprintf(stderr, "%s:%d: check failed: %s, with %s\n", file, line, expression, values.c_str());
    std::abort();
}

}  // namespace tumble::debug
