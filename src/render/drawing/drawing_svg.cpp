// Writes a drawing as an SVG document. Numbers have two decimals, which is finer than any pixel and keeps files small.
#include <array>
#include <charconv>
#include <string_view>

#include "tumble/drawing.hpp"

namespace tumble {

namespace {

std::string number(double value) {
    std::array<char, 64> buffer{};
    const auto [end, error] =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, 2);
    if (error != std::errc()) return "0";
    std::string text(buffer.data(), end);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text == "-0" ? "0" : text;
}

std::string attribute(std::string_view name, std::string_view value) {
    return " " + std::string(name) + "=\"" + std::string(value) + "\"";
}

std::string paint(std::string_view name, Color color) {
    if (color.a == 0) return attribute(name, "none");
    constexpr std::string_view kHex = "0123456789abcdef";
    std::string hex = "#";
    for (const int channel : {int{color.r}, int{color.g}, int{color.b}}) {
        hex += kHex[static_cast<std::size_t>(channel >> 4)];
        hex += kHex[static_cast<std::size_t>(channel & 15)];
    }
    std::string text = attribute(name, hex);
    if (color.a != 255) text += attribute(std::string(name) + "-opacity", number(color.a / 255.0));
    return text;
}

std::string outline(double width, Color color) {
    if (width <= 0.0) return "";
    return paint("stroke", color) + attribute("stroke-width", number(width)) + attribute("stroke-linejoin", "round");
}

std::string element(const DrawnLine& line) {
    if (line.width <= 0.0) return "";
    return "<line" + attribute("x1", number(line.from.x)) + attribute("y1", number(line.from.y)) +
           attribute("x2", number(line.to.x)) + attribute("y2", number(line.to.y)) + paint("stroke", line.color) +
           attribute("stroke-width", number(line.width)) + attribute("stroke-linecap", "round") + "/>\n";
}

std::string element(const DrawnPolygon& polygon) {
    std::string points;
    for (const DVec2 p : polygon.points) points += (points.empty() ? "" : " ") + number(p.x) + "," + number(p.y);
    return "<polygon" + attribute("points", points) + paint("fill", polygon.fill) +
           outline(polygon.outline_width, polygon.outline) + "/>\n";
}

std::string element(const DrawnDisc& disc) {
    return "<circle" + attribute("cx", number(disc.center.x)) + attribute("cy", number(disc.center.y)) +
           attribute("r", number(disc.radius)) + paint("fill", disc.fill) + outline(disc.outline_width, disc.outline) +
           "/>\n";
}

std::string element(const DrawnText& text) {
    constexpr std::array<std::string_view, 3> kAnchors = {"start", "middle", "end"};
    return "<text" + attribute("x", number(text.at.x)) + attribute("y", number(text.at.y)) +
           attribute("font-size", number(text.size)) + paint("fill", text.color) +
           attribute("text-anchor", kAnchors[static_cast<std::size_t>(text.anchor)]) + ">" + escape_markup(text.text) +
           "</text>\n";
}

// Control characters that XML 1.0 cannot express.
bool is_forbidden(char c) { return static_cast<unsigned char>(c) < 0x20u && c != '\t' && c != '\n' && c != '\r'; }

}  // namespace

std::string escape_markup(std::string_view text) {
    std::string escaped;
    for (const char c : text) {
        switch (c) {
            case '&': escaped += "&amp;"; break;
            case '<': escaped += "&lt;"; break;
            case '>': escaped += "&gt;"; break;
            case '"': escaped += "&quot;"; break;
            default: escaped += is_forbidden(c) ? '?' : c;
        }
    }
    return escaped;
}

std::string to_svg(const Drawing& drawing) {
    const std::string width = std::to_string(drawing.width), height = std::to_string(drawing.height);
    std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\"" + attribute("width", width) +
                      attribute("height", height) + attribute("viewBox", "0 0 " + width + " " + height) +
                      attribute("font-family", "DejaVu Sans, Verdana, sans-serif") + ">\n";
    svg +=
        "<rect" + attribute("width", width) + attribute("height", height) + paint("fill", drawing.background) + "/>\n";
    for (const DrawnElement& drawn : drawing.elements)
        svg += std::visit([](const auto& value) { return element(value); }, drawn);
    return svg + "</svg>\n";
}

}  // namespace tumble
