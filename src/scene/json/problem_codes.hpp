// The codes of diagnostics. Each has a page in problems.cpp.
#pragma once

#include <string_view>

namespace tumble::scene {

namespace codes {

inline constexpr std::string_view no_mass = "no-mass";
inline constexpr std::string_view static_velocity = "static-velocity";
inline constexpr std::string_view unused_mass = "unused-mass";
inline constexpr std::string_view missing_image = "missing-image";
inline constexpr std::string_view radians = "radians";
inline constexpr std::string_view outside_limits = "outside-limits";
inline constexpr std::string_view sliver = "sliver";
inline constexpr std::string_view unusual_size = "unusual-size";
inline constexpr std::string_view ignored_vertices = "ignored-vertices";
inline constexpr std::string_view fast_body = "fast-body";
inline constexpr std::string_view behind_chain = "behind-chain";
inline constexpr std::string_view overlap = "overlap";
inline constexpr std::string_view contact_mass_ratio = "contact-mass-ratio";
inline constexpr std::string_view asleep_in_the_air = "asleep-in-the-air";
inline constexpr std::string_view sinking_stack = "sinking-stack";
inline constexpr std::string_view spread_impact = "spread-impact";
inline constexpr std::string_view joint_mass_ratio = "joint-mass-ratio";
inline constexpr std::string_view open_joint = "open-joint";
inline constexpr std::string_view far_anchor = "far-anchor";
inline constexpr std::string_view stiff_spring = "stiff-spring";
inline constexpr std::string_view joined_copies = "joined-copies";
inline constexpr std::string_view after_the_end = "after-the-end";
inline constexpr std::string_view useless_force = "useless-force";
inline constexpr std::string_view event_after_removal = "event-after-removal";

inline constexpr std::string_view json = "json";
inline constexpr std::string_view drawing = "drawing";
inline constexpr std::string_view scene = "scene";
inline constexpr std::string_view world = "world";
inline constexpr std::string_view camera = "camera";
inline constexpr std::string_view include = "include";
inline constexpr std::string_view material = "material";
inline constexpr std::string_view body = "body";
inline constexpr std::string_view shape = "shape";
inline constexpr std::string_view joint = "joint";
inline constexpr std::string_view event = "event";
inline constexpr std::string_view claim = "claim";

}  // namespace codes

// The code of an error in the value at a JSON pointer: that of the kind of object around it.
std::string_view code_of_error(std::string_view pointer);

}  // namespace tumble::scene
