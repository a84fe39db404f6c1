// The style of an element, which decides what it becomes: properties from attributes, style sheets and the elements
// around it.
#pragma once

#include <map>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>

#include "tumble/body.hpp"

namespace tumble::scene {

// The rules of <style> elements whose selector is a tag, a .class or an #id.
class SvgSheet {
public:
    // Adds the rules of one sheet. Returns the number of rules with other selectors, which are left out.
    int add(std::string_view text);

    // The last value among the most specific rules: id over class over tag. Empty if there is none.
    std::string_view find(const pugi::xml_node& element, std::string_view property) const;

private:
    std::map<std::string, std::map<std::string, std::string, std::less<>>, std::less<>> rules_;  // [selector][property]
};

struct SvgPaint {
    bool visible = false;
    std::string color;  // "#rrggbb"; empty for a gradient, pattern or unknown colour
    double alpha = 1.0;
};

struct SvgStyle {
    SvgPaint fill{true, "#000000"};
    SvgPaint stroke;
    double stroke_width = 1.0;
    double fill_opacity = 1.0, stroke_opacity = 1.0;
    double opacity = 1.0;  // with that of the groups around
    bool even_odd = false;
    bool visible = true;
    std::optional<BodyType> type;  // as the drawing states it; empty: by the rule of make_svg_body()
};

// The style of an element inside an element of the style `around`. Adds gradients and patterns to `gradients`.
// Throws SvgError for a body type that does not exist.
SvgStyle read_style(const pugi::xml_node& element, const SvgSheet& sheet, const SvgStyle& around, int& gradients);

// The style with its opacities in its paints: a transparent paint is not visible, others have the colour that they have
// on white paper. `mixed` is increased if one is neither transparent nor opaque.
SvgStyle with_opacity(const SvgStyle& style, int& mixed);

// The name that the drawing program shows for an element (inkscape:label), or else its id. May be empty.
std::string_view label_of(const pugi::xml_node& element);

// A property's value: from the style attribute, otherwise from the sheet, otherwise from the attribute of that name.
// May be empty.
std::string_view find_property(const pugi::xml_node& element, const SvgSheet& sheet, std::string_view property);

}  // namespace tumble::scene
