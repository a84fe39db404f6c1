// What an element looks like, and so what it becomes: style properties, from attributes, style sheets and the elements
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
    // Adds the rules of one sheet. Returns how many rules with other selectors were left out.
    int add(std::string_view text);

    // The last value among the most specific rules: id over class over tag. Empty if there is none.
    std::string_view find(const pugi::xml_node& element, std::string_view property) const;

private:
    std::map<std::string, std::map<std::string, std::string, std::less<>>, std::less<>> rules_;  // [selector][property]
};

struct SvgPaint {
    bool visible = false;
    std::string color;  // "#rrggbb"; empty if it is not one colour
};

struct SvgStyle {
    SvgPaint fill{true, "#000000"};
    SvgPaint stroke;
    double stroke_width = 1.0;
    bool even_odd = false;
    bool visible = true;
    std::optional<BodyType> type;  // as the user asks for, else by the rule
};

// The style of an element inside something of the style `around`. `gradients` counts paints that are not one colour.
// Throws SvgError for a body type that does not exist.
SvgStyle read_style(const pugi::xml_node& element, const SvgSheet& sheet, const SvgStyle& around, int& gradients);

// A property's value: of the style attribute, else of the sheet, else of the attribute by its name; may be empty.
std::string_view find_property(const pugi::xml_node& element, const SvgSheet& sheet, std::string_view property);

}  // namespace tumble::scene
