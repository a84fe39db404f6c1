// The colour keywords are those of CSS Color 4, section 6.1.
#include "import/svg/svg_color.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "import/svg/svg_text.hpp"
#include "tumble/math.hpp"

namespace tumble::scene {

namespace {

constexpr std::array<std::pair<std::string_view, unsigned>, 148> kNamed{{{"aliceblue", 0xf0f8ff},
                                                                         {"antiquewhite", 0xfaebd7},
                                                                         {"aqua", 0x00ffff},
                                                                         {"aquamarine", 0x7fffd4},
                                                                         {"azure", 0xf0ffff},
                                                                         {"beige", 0xf5f5dc},
                                                                         {"bisque", 0xffe4c4},
                                                                         {"black", 0x000000},
                                                                         {"blanchedalmond", 0xffebcd},
                                                                         {"blue", 0x0000ff},
                                                                         {"blueviolet", 0x8a2be2},
                                                                         {"brown", 0xa52a2a},
                                                                         {"burlywood", 0xdeb887},
                                                                         {"cadetblue", 0x5f9ea0},
                                                                         {"chartreuse", 0x7fff00},
                                                                         {"chocolate", 0xd2691e},
                                                                         {"coral", 0xff7f50},
                                                                         {"cornflowerblue", 0x6495ed},
                                                                         {"cornsilk", 0xfff8dc},
                                                                         {"crimson", 0xdc143c},
                                                                         {"cyan", 0x00ffff},
                                                                         {"darkblue", 0x00008b},
                                                                         {"darkcyan", 0x008b8b},
                                                                         {"darkgoldenrod", 0xb8860b},
                                                                         {"darkgray", 0xa9a9a9},
                                                                         {"darkgreen", 0x006400},
                                                                         {"darkgrey", 0xa9a9a9},
                                                                         {"darkkhaki", 0xbdb76b},
                                                                         {"darkmagenta", 0x8b008b},
                                                                         {"darkolivegreen", 0x556b2f},
                                                                         {"darkorange", 0xff8c00},
                                                                         {"darkorchid", 0x9932cc},
                                                                         {"darkred", 0x8b0000},
                                                                         {"darksalmon", 0xe9967a},
                                                                         {"darkseagreen", 0x8fbc8f},
                                                                         {"darkslateblue", 0x483d8b},
                                                                         {"darkslategray", 0x2f4f4f},
                                                                         {"darkslategrey", 0x2f4f4f},
                                                                         {"darkturquoise", 0x00ced1},
                                                                         {"darkviolet", 0x9400d3},
                                                                         {"deeppink", 0xff1493},
                                                                         {"deepskyblue", 0x00bfff},
                                                                         {"dimgray", 0x696969},
                                                                         {"dimgrey", 0x696969},
                                                                         {"dodgerblue", 0x1e90ff},
                                                                         {"firebrick", 0xb22222},
                                                                         {"floralwhite", 0xfffaf0},
                                                                         {"forestgreen", 0x228b22},
                                                                         {"fuchsia", 0xff00ff},
                                                                         {"gainsboro", 0xdcdcdc},
                                                                         {"ghostwhite", 0xf8f8ff},
                                                                         {"gold", 0xffd700},
                                                                         {"goldenrod", 0xdaa520},
                                                                         {"gray", 0x808080},
                                                                         {"green", 0x008000},
                                                                         {"greenyellow", 0xadff2f},
                                                                         {"grey", 0x808080},
                                                                         {"honeydew", 0xf0fff0},
                                                                         {"hotpink", 0xff69b4},
                                                                         {"indianred", 0xcd5c5c},
                                                                         {"indigo", 0x4b0082},
                                                                         {"ivory", 0xfffff0},
                                                                         {"khaki", 0xf0e68c},
                                                                         {"lavender", 0xe6e6fa},
                                                                         {"lavenderblush", 0xfff0f5},
                                                                         {"lawngreen", 0x7cfc00},
                                                                         {"lemonchiffon", 0xfffacd},
                                                                         {"lightblue", 0xadd8e6},
                                                                         {"lightcoral", 0xf08080},
                                                                         {"lightcyan", 0xe0ffff},
                                                                         {"lightgoldenrodyellow", 0xfafad2},
                                                                         {"lightgray", 0xd3d3d3},
                                                                         {"lightgreen", 0x90ee90},
                                                                         {"lightgrey", 0xd3d3d3},
                                                                         {"lightpink", 0xffb6c1},
                                                                         {"lightsalmon", 0xffa07a},
                                                                         {"lightseagreen", 0x20b2aa},
                                                                         {"lightskyblue", 0x87cefa},
                                                                         {"lightslategray", 0x778899},
                                                                         {"lightslategrey", 0x778899},
                                                                         {"lightsteelblue", 0xb0c4de},
                                                                         {"lightyellow", 0xffffe0},
                                                                         {"lime", 0x00ff00},
                                                                         {"limegreen", 0x32cd32},
                                                                         {"linen", 0xfaf0e6},
                                                                         {"magenta", 0xff00ff},
                                                                         {"maroon", 0x800000},
                                                                         {"mediumaquamarine", 0x66cdaa},
                                                                         {"mediumblue", 0x0000cd},
                                                                         {"mediumorchid", 0xba55d3},
                                                                         {"mediumpurple", 0x9370db},
                                                                         {"mediumseagreen", 0x3cb371},
                                                                         {"mediumslateblue", 0x7b68ee},
                                                                         {"mediumspringgreen", 0x00fa9a},
                                                                         {"mediumturquoise", 0x48d1cc},
                                                                         {"mediumvioletred", 0xc71585},
                                                                         {"midnightblue", 0x191970},
                                                                         {"mintcream", 0xf5fffa},
                                                                         {"mistyrose", 0xffe4e1},
                                                                         {"moccasin", 0xffe4b5},
                                                                         {"navajowhite", 0xffdead},
                                                                         {"navy", 0x000080},
                                                                         {"oldlace", 0xfdf5e6},
                                                                         {"olive", 0x808000},
                                                                         {"olivedrab", 0x6b8e23},
                                                                         {"orange", 0xffa500},
                                                                         {"orangered", 0xff4500},
                                                                         {"orchid", 0xda70d6},
                                                                         {"palegoldenrod", 0xeee8aa},
                                                                         {"palegreen", 0x98fb98},
                                                                         {"paleturquoise", 0xafeeee},
                                                                         {"palevioletred", 0xdb7093},
                                                                         {"papayawhip", 0xffefd5},
                                                                         {"peachpuff", 0xffdab9},
                                                                         {"peru", 0xcd853f},
                                                                         {"pink", 0xffc0cb},
                                                                         {"plum", 0xdda0dd},
                                                                         {"powderblue", 0xb0e0e6},
                                                                         {"purple", 0x800080},
                                                                         {"rebeccapurple", 0x663399},
                                                                         {"red", 0xff0000},
                                                                         {"rosybrown", 0xbc8f8f},
                                                                         {"royalblue", 0x4169e1},
                                                                         {"saddlebrown", 0x8b4513},
                                                                         {"salmon", 0xfa8072},
                                                                         {"sandybrown", 0xf4a460},
                                                                         {"seagreen", 0x2e8b57},
                                                                         {"seashell", 0xfff5ee},
                                                                         {"sienna", 0xa0522d},
                                                                         {"silver", 0xc0c0c0},
                                                                         {"skyblue", 0x87ceeb},
                                                                         {"slateblue", 0x6a5acd},
                                                                         {"slategray", 0x708090},
                                                                         {"slategrey", 0x708090},
                                                                         {"snow", 0xfffafa},
                                                                         {"springgreen", 0x00ff7f},
                                                                         {"steelblue", 0x4682b4},
                                                                         {"tan", 0xd2b48c},
                                                                         {"teal", 0x008080},
                                                                         {"thistle", 0xd8bfd8},
                                                                         {"tomato", 0xff6347},
                                                                         {"turquoise", 0x40e0d0},
                                                                         {"violet", 0xee82ee},
                                                                         {"wheat", 0xf5deb3},
                                                                         {"white", 0xffffff},
                                                                         {"whitesmoke", 0xf5f5f5},
                                                                         {"yellow", 0xffff00},
                                                                         {"yellowgreen", 0x9acd32}}};
static_assert(std::ranges::is_sorted(kNamed));

constexpr std::string_view kDigits = "0123456789abcdef";

std::string to_hex(unsigned rgb) {
    std::string text = "#";
    for (int shift = 20; shift >= 0; shift -= 4) text += kDigits[(rgb >> shift) & 15u];
    return text;
}

unsigned from_hex(std::string_view digits) {
    unsigned value = 0;
    for (const char digit : digits) value = value << 4 | static_cast<unsigned>(kDigits.find(digit));
    return value;
}

// #rgb and #rgba stand for doubled digits.
std::optional<SvgColor> parse_hex(const std::string& text) {
    if (text.find_first_not_of(kDigits, 1) != std::string::npos) return std::nullopt;
    std::string digits = text.substr(1);
    if (digits.size() == 3 || digits.size() == 4) {
        std::string doubled;
        for (const char digit : digits) doubled += {digit, digit};
        digits = doubled;
    }
    if (digits.size() != 6 && digits.size() != 8) return std::nullopt;
    const double alpha = digits.size() == 8 ? from_hex(std::string_view(digits).substr(6)) / 255.0 : 1.0;
    return SvgColor{'#' + digits.substr(0, 6), alpha};
}

unsigned to_byte(double value) { return static_cast<unsigned>(std::lround(std::clamp(value, 0.0, 255.0))); }

std::string to_hex(const std::array<double, 3>& channels) {
    return to_hex(to_byte(channels[0]) << 16 | to_byte(channels[1]) << 8 | to_byte(channels[2]));
}

double read_opacity(SvgScanner& scanner) {
    const double value = scanner.number();
    return std::clamp(scanner.take_if('%') ? value / 100.0 : value, 0.0, 1.0);
}

// The alpha after the colour, after a comma or a slash; 1 if there is none.
double read_alpha(SvgScanner& scanner) {
    scanner.take_if('/');
    return scanner.take_if(')') ? 1.0 : read_opacity(scanner);
}

SvgColor read_rgb(SvgScanner& scanner) {
    std::array<double, 3> channels{};
    for (double& channel : channels) {
        channel = scanner.number();
        if (scanner.take_if('%')) channel *= 2.55;
    }
    return {to_hex(channels), read_alpha(scanner)};
}

// Degrees without a unit, in the range of 0 to 360.
double read_hue(SvgScanner& scanner) {
    constexpr std::array<std::pair<std::string_view, double>, 4> kUnits{
        {{"deg", 1.0}, {"grad", 0.9}, {"rad", 180.0 / kPi}, {"turn", 360.0}}};
    double hue = scanner.number();
    if (scanner.peek() >= 'a' && scanner.peek() <= 'z') {
        const std::string_view unit = scanner.word();
        const auto found = std::ranges::find(kUnits, unit, [](const auto& known) { return known.first; });
        if (found == kUnits.end()) throw SvgError("unknown unit of an angle");
        hue *= found->second;
    }
    return hue - 360.0 * std::floor(hue / 360.0);
}

// CSS Color 4, section 7.1.
SvgColor read_hsl(SvgScanner& scanner) {
    const double hue = read_hue(scanner);
    double parts[2];  // saturation and lightness
    for (double& part : parts) {
        part = std::clamp(scanner.number() / 100.0, 0.0, 1.0);
        scanner.take_if('%');
    }
    const double saturation = parts[0], lightness = parts[1];
    const double reach = saturation * std::min(lightness, 1.0 - lightness);
    std::array<double, 3> channels{};
    for (std::size_t i = 0; i < 3; ++i) {
        constexpr std::array<double, 3> kStart{0.0, 8.0, 4.0};
        const double at = std::fmod(kStart[i] + hue / 30.0, 12.0);
        channels[i] = 255.0 * (lightness - reach * std::clamp(std::min(at - 3.0, 9.0 - at), -1.0, 1.0));
    }
    return {to_hex(channels), read_alpha(scanner)};
}

template <class Read>
std::optional<SvgColor> parse_function(std::string_view arguments, Read read) {
    SvgScanner scanner(arguments);
    try {
        scanner.expect('(');
        return read(scanner);
    } catch (const SvgError&) {
        return std::nullopt;
    }
}

}  // namespace

std::optional<SvgColor> parse_color(std::string_view given) {
    std::string text(trimmed(given));
    std::ranges::transform(text, text.begin(), to_lower);
    if (text.starts_with('#')) return parse_hex(text);
    const std::string_view name = std::string_view(text).substr(0, text.find('('));
    const std::string_view arguments = std::string_view(text).substr(name.size());
    if (name == "rgb" || name == "rgba") return parse_function(arguments, read_rgb);
    if (name == "hsl" || name == "hsla") return parse_function(arguments, read_hsl);
    const auto found =
        std::ranges::lower_bound(kNamed, std::string_view(text), {}, [](const auto& named) { return named.first; });
    if (found == kNamed.end() || found->first != text) return std::nullopt;
    return SvgColor{to_hex(found->second)};
}

std::optional<double> parse_opacity(std::string_view text) {
    SvgScanner scanner(text);
    try {
        return read_opacity(scanner);
    } catch (const SvgError&) {
        return std::nullopt;
    }
}

std::string mixed_with_white(const std::string& rgb, double opacity) {
    std::array<double, 3> channels{};
    for (std::size_t i = 0; i < 3; ++i)
        channels[i] = 255.0 + opacity * (from_hex(std::string_view(rgb).substr(1 + 2 * i, 2)) - 255.0);
    return to_hex(channels);
}

}  // namespace tumble::scene
