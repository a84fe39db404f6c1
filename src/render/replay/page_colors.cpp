#include "render/replay/page_colors.hpp"

#include <array>
#include <cstdio>
#include <utility>

#include "render/replay/header_json.hpp"
#include "render/style/theme.hpp"
#include "tumble/render.hpp"

namespace tumble::render {
namespace {

std::string rule_of(Theme theme) {
    const Colors& colors = colors_of(theme);
    const std::pair<const char*, Color> variables[] = {{"ground", colors.background},
                                                       {"minor", colors.minor_grid},
                                                       {"major", colors.major_grid},
                                                       {"text", colors.text},
                                                       {"ink", is_dark(theme) ? colors.tint : colors.shade},
                                                       {"contact", colors.overlapping},
                                                       {"normal", colors.normal},
                                                       {"box", colors.box_edge},
                                                       {"velocity", colors.velocity},
                                                       {"joint", colors.joint},
                                                       {"anchor", colors.anchor}};
    std::string rule = ":root[data-theme=\"" + std::string(name_of(theme)) + "\"] {";
    for (const auto& [name, color] : variables) rule += std::string(" --") + name + ": " + to_hex(color) + ";";
    std::array<char, 64> share{};
    std::snprintf(share.data(), share.size(), " --outline-share: %g; }\n", colors.outline_share);
    return rule + share.data();
}

}  // namespace

std::string page_colors() {
    std::string rules;
    for (const ThemeName& theme : kThemes) rules += rule_of(theme.theme);
    return rules;
}

}  // namespace tumble::render
