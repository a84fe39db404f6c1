// What the frames of a scene show, and how they look: the member `camera` of a Scene. No effect on the simulation.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tumble/math.hpp"

namespace tumble {

// The colours of frames and replays.
enum class Theme { light, dark, print, high_contrast, color_blind };

// The themes by their names.
struct ThemeName {
    std::string_view name;
    Theme theme;
};
inline constexpr std::array<ThemeName, 5> kThemes{{{"light", Theme::light},
                                                   {"dark", Theme::dark},
                                                   {"print", Theme::print},
                                                   {"high_contrast", Theme::high_contrast},
                                                   {"color_blind", Theme::color_blind}}};

// How frames look. The themes light and dark keep the colours of materials, the others replace them by their own.
struct SceneStyle {
    Theme theme = Theme::light;
    bool outlines = true;   // along the edges of shapes
    bool hatching = false;  // over static shapes
    bool shadows = false;   // of bodies that are not static
};

// The view at a time. Until the next key frame it changes smoothly into the view of that one. Key frames that state
// neither a centre nor bodies, or no height, keep those of the key frame before; the first keeps those of the camera.
struct SceneCameraKey {
    double time = 0.0;                // s
    std::optional<DVec2> center;      // m, the middle of the frame
    std::vector<std::string> follow;  // or names of bodies: the middle of their bounding boxes
    std::optional<double> height;     // m; default with `follow`: all of these bodies are in view
};

// A text over the bodies.
struct SceneNote {
    std::string text;                 // may have several lines
    std::optional<DVec2> position{};  // m, the point below it
    std::string above{};              // or the name of the body that it stays above
    double from = 0.0;                // s
    std::optional<double> until{};    // s; default: the end of the run
};

// A title over the first frames.
struct SceneCard {
    std::string title;
    std::string text;    // below the title, may have several lines
    double until = 2.0;  // s
};

struct SceneCamera {
    std::optional<DVec2> center{};   // m; default: everything in view; with `follow`: when the body first exists
    std::optional<double> height{};  // m of the world from the lower to the upper edge
    std::string follow{};            // name of a body, also of one that the timeline spawns, or empty
    SceneStyle style{};
    std::vector<SceneCameraKey> keys{};  // in the order of time
    std::vector<SceneNote> notes{};
    std::optional<SceneCard> card{};
};

}  // namespace tumble
