#include "tools/output/plot_colors.hpp"

#include <array>
#include <charconv>

namespace tumble::tools {

namespace {

constexpr std::array<PlotColor, 7> kInks{{{"tumble", "#1e6cb5", "#63aef0"},
                                          {"second", "#2e8b57", "#6fd39c"},
                                          {"box2d", "#d66e14", "#f39a4c"},
                                          {"exact", "#37474f", "#cfd8dc"},
                                          {"limit", "#c62828", "#ff6e66"},
                                          {"violet", "#7b3fb0", "#c39bf0"},
                                          {"teal", "#00838f", "#4fd0dc"}}};

constexpr std::array<PlotColor, 4> kParts{kTextColor, kRuleColor, kHeadColor, kBandColor};

std::string value_of(const PlotColor& color, Scheme scheme) {
    return scheme == Scheme::fixed ? std::string(color.light) : "var(--" + std::string(color.name) + ")";
}

}  // namespace

const PlotColor& plot_color(Ink ink) { return kInks.at(static_cast<std::size_t>(ink)); }

std::string plot_variables(bool is_dark) {
    std::string text;
    const auto add = [&](const PlotColor& color) {
        text += " --" + std::string(color.name) + ": " + std::string(is_dark ? color.dark : color.light) + ";";
    };
    for (const PlotColor& color : kParts) add(color);
    for (const PlotColor& color : kInks) add(color);
    return text;
}

std::string plot_style(Scheme scheme) {
    std::string text = ".plot { font: 12px \"DejaVu Sans\", Verdana, sans-serif; } .plot text { fill: " +
                       value_of(kTextColor, scheme) + "; } .plot .heading { font-weight: bold; font-size: 13px; }\n" +
                       ".plot .grid { stroke: " + value_of(kRuleColor, scheme) +
                       "; } .plot .frame { fill: none; stroke: " + value_of(kHeadColor, scheme) +
                       "; } .plot .band { fill: " + value_of(kBandColor, scheme) + "; }\n" +
                       ".plot .line { fill: none; stroke-width: 1.8; stroke-linejoin: round; } "
                       ".plot .dashed { stroke-dasharray: 6 4; } .plot .point { fill-opacity: .8; }\n";
    for (const PlotColor& ink : kInks) {
        const std::string name = std::string(ink.name), color = value_of(ink, scheme);
        text += ".plot .line." + name + " { stroke: " + color + "; } .plot .point." + name + ", .plot .bar." + name +
                " { fill: " + color + "; }\n";
    }
    return text;
}

Color color_of(const PlotColor& color, bool is_dark) {
    const std::string_view text = is_dark ? color.dark : color.light;
    const auto channel = [&](std::size_t at) {
        int value = 255;
        if (at < text.size()) std::from_chars(text.data() + at, text.data() + at + 2, value, 16);
        return static_cast<std::uint8_t>(value);
    };
    return {channel(1), channel(3), channel(5), channel(7)};
}

}  // namespace tumble::tools
