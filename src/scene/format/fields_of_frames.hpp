// The fields of what frames show: the camera, its key frames, the style, notes and the title card.
#pragma once

#include "scene/format/field.hpp"

namespace tumble::scene {

template <>
inline constexpr auto kEnumNames<Theme> = [] {
    std::array<std::pair<Theme, std::string_view>, kThemes.size()> names;
    for (std::size_t i = 0; i < names.size(); ++i) names[i] = {kThemes[i].theme, kThemes[i].name};
    return names;
}();

inline constexpr Range kViewHeight{0.0, kFarthest, true};  // m

template <class V>
void visit_fields(V& v, Type<SceneStyle>) {
    v.field(
        {"theme",
         "Colours of the background, of bodies and of texts: 'light', 'dark', 'print' (greys on white), "
         "'high_contrast' (bright on black) or 'color_blind' (hues that all eyes tell apart). The last three replace "
         "the colours of materials. The option --theme replaces the theme."},
        &SceneStyle::theme);
    v.field({"outlines", "Whether the edges of shapes are drawn."}, &SceneStyle::outlines);
    v.field({"hatching", "Whether static shapes are hatched."}, &SceneStyle::hatching);
    v.field({"shadows", "Whether bodies that can move have a shadow."}, &SceneStyle::shadows);
}

template <class V>
void visit_fields(V& v, Type<SceneCameraKey>) {
    v.field(
        {.name = "time", .description = "When the view is this one.", .unit = "s", .range = kTime, .required = true},
        &SceneCameraKey::time);
    v.field(
        {"center", "World point in the middle of the frame. Default: that of the key frame before.", "m", kPosition},
        &SceneCameraKey::center);
    v.field({.name = "follow",
             .description = "Names of bodies: the middle of their bounding boxes is in the middle of the frame, also "
                            "while they move. Bodies that do not exist at a time are left out.",
             .min_items = 1,
             .max_items = 1000,
             .text = Text::name},
            &SceneCameraKey::follow);
    v.field({"height",
             "Height of the part of the world that the frame shows. Default: that of the key frame before; with "
             "'follow', all of these bodies are in view.",
             "m", kViewHeight},
            &SceneCameraKey::height);
    v.at_most_one("center", "follow");
}

template <class V>
void visit_fields(V& v, Type<SceneNote>) {
    v.field({.name = "text",
             .description = "The text, which may have several lines.",
             .required = true,
             .text = Text::caption},
            &SceneNote::text);
    v.field({"position", "World point below the text.", "m", kPosition}, &SceneNote::position);
    v.field({.name = "above", .description = "Name of the body that the text stays above.", .text = Text::name},
            &SceneNote::above);
    v.field({"from", "When the text appears.", "s", kTime}, &SceneNote::from);
    v.field({"until", "When the text disappears. Default: at the end of the run.", "s", kTime}, &SceneNote::until);
    v.exactly_one({"position", "above"});
}

template <class V>
void visit_fields(V& v, Type<SceneCard>) {
    v.field({.name = "title", .description = "The title.", .required = true, .text = Text::caption}, &SceneCard::title);
    v.field({.name = "text",
             .description = "Smaller text below the title, which may have several lines.",
             .text = Text::caption},
            &SceneCard::text);
    v.field({"until", "When the card disappears.", "s", kInterval}, &SceneCard::until);
}

template <class V>
void visit_fields(V& v, Type<SceneCamera>) {
    v.field({"center",
             "World point in the middle of the frame. Default: chosen, with the height, so that the frame shows all "
             "moving bodies, most of their paths, and the ground and the bodies near them. With 'follow': the middle "
             "of the frame when the followed body first appears.",
             "m", kPosition},
            &SceneCamera::center);
    v.field({"height",
             "Height of the part of the world that the frame shows. Default: chosen as described for 'center'; with "
             "'follow', five times the longer side of the followed body.",
             "m", kViewHeight},
            &SceneCamera::height);
    v.field(
        {.name = "follow",
         .description = "Name of a body that the camera moves with. The body stays in the middle of the frame, or at "
                        "the offset that 'center' gives it. A body that the timeline spawns is followed from then on.",
         .text = Text::name},
        &SceneCamera::follow);
    v.field({"style", "How frames look."}, &SceneCamera::style);
    v.field({.name = "keys",
             .description = "Key frames of the camera in the order of time: the view pans and zooms from one to the "
                            "next. Before the first and after the last key frame the view is theirs.",
             .max_items = 10000},
            &SceneCamera::keys);
    v.field({.name = "notes", .description = "Texts over the bodies.", .max_items = 1000}, &SceneCamera::notes);
    v.field({"card", "A title over the first frames."}, &SceneCamera::card);
}

}  // namespace tumble::scene
