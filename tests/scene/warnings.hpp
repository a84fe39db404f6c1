// The warnings of `validate` for small scenes.
#pragma once

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "tumble/scene_file.hpp"

namespace tumble::test {

// Of a scene with these bodies, the further members `rest`, and overrides as of `--set`.
inline std::vector<Diagnostic> warnings_of(const std::string& bodies, const std::string& rest = "",
                                           const std::vector<std::string>& overrides = {}) {
    std::vector<Diagnostic> warnings;
    parse_scene(R"({"format": 1, "bodies": [)" + bodies + "]" + rest + "}", "scene.json",
                {.overrides = overrides, .seed = {}, .lint = true}, &warnings);
    return warnings;
}

// The only warning.
inline Diagnostic warning_of(const std::string& bodies, const std::string& rest = "",
                             const std::vector<std::string>& overrides = {}) {
    const std::vector<Diagnostic> warnings = warnings_of(bodies, rest, overrides);
    REQUIRE_MESSAGE(warnings.size() == 1, bodies << " has " << warnings.size() << " warnings");
    CHECK(warnings[0].severity == Diagnostic::Severity::warning);
    CHECK(!warnings[0].hint.empty());
    CHECK(warnings[0].line > 0);
    return warnings[0];
}

inline bool says(const Diagnostic& warning, const std::string& part) {
    return warning.message.find(part) != std::string::npos;
}

}  // namespace tumble::test
