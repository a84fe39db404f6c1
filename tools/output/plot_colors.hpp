// The colours of plots, and the style sheets that give them to the elements of to_svg().
#pragma once

#include <string>
#include <string_view>

#include "tools/output/plot.hpp"

namespace tumble::tools {

// A colour by its name in style sheets, as "#rrggbb" in the light and the dark scheme of a page.
struct PlotColor {
    std::string_view name, light, dark;
};

const PlotColor& plot_color(Ink ink);

// Those of text, grid, frame and band.
inline constexpr PlotColor kTextColor{"text", "#263238", "#dde4e8"};
inline constexpr PlotColor kRuleColor{"rule", "#e0e6ea", "#2b353b"};
inline constexpr PlotColor kHeadColor{"head", "#b0bec5", "#4a5a63"};
inline constexpr PlotColor kPageColor{"page", "#ffffff", "#14191d"};  // behind a drawing
inline constexpr PlotColor kBandColor{"band", "#2e7d3226", "#66bb6a33"};

// "--tumble: #1e6cb5; ...": the variables of a scheme.
std::string plot_variables(bool is_dark);

// The rules for the classes of to_svg(): with the variables of the page, or with the light colours themselves.
enum class Scheme { variable, fixed };
std::string plot_style(Scheme scheme);

// The light or the dark colour for drawings, of "#rrggbb" or "#rrggbbaa".
Color color_of(const PlotColor& color, bool is_dark);

}  // namespace tumble::tools
