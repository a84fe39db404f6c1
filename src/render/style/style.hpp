// The look of a frame: calm, light, the same in every scene. Lengths are pixels at 720 rows (see View::detail).
#pragma once

#include <array>

#include "render/style/color.hpp"

namespace tumble::render::style {

inline constexpr Color kBackground{247, 248, 250};
inline constexpr Color kMinorGrid{238, 240, 244};
inline constexpr Color kMajorGrid{227, 231, 237};

inline constexpr Color kStatic{203, 209, 218};
inline constexpr Color kKinematic{136, 149, 171};

// An outline is its fill mixed with kInk, or with the background if the fill is darker than kDarkLuma.
inline constexpr Color kInk{36, 46, 62};
inline constexpr double kOutlineShare = 0.42;   // of what is mixed in
inline constexpr double kDarkLuma = 0.4;        // 0 to 1
inline constexpr double kInstanceShade = 0.10;  // largest change in lightness among copies of a body

// Fills of dynamic bodies, in the order in which names occur. Neighbours differ in hue; all have a similar lightness.
inline constexpr std::array<Color, 8> kBodies{{
    {104, 154, 211},  // blue
    {240, 178, 92},   // amber
    {98, 181, 165},   // teal
    {228, 127, 108},  // coral
    {150, 134, 202},  // violet
    {148, 188, 106},  // green
    {219, 139, 170},  // rose
    {193, 164, 123},  // sand
}};

inline constexpr double kOutline = 1.5;        // width
inline constexpr double kSegment = 2.5;        // width of a shape without area
inline constexpr double kBand = 22.0;          // width of the band on the solid side of a chain
inline constexpr double kBandMetres = 0.6;     // largest width of that band (m)
inline constexpr double kBandOpacity = 0.4;    // of the band at the chain
inline constexpr double kSensorOpacity = 0.3;  // of the area of a sensor
inline constexpr double kSensorEdge = 1.6;     // width of the dashed edge of a sensor
inline constexpr double kDash = 6.0;           // length of its dashes
inline constexpr double kDashGap = 5.0;        // length of its gaps
inline constexpr double kMark = 1.5;           // width of an orientation mark
inline constexpr double kSmallestMark = 8.0;   // a shape has none if half its smaller extent is below this
inline constexpr double kAnchor = 3.2;         // radius of a joint's anchor

inline constexpr double kRope = 2.6;  // width of a rope

inline constexpr Color kJoint{74, 85, 104};
inline constexpr Color kRopeColor{150, 118, 78};
inline constexpr Color kAnchorFill{250, 251, 252};
inline constexpr Color kText{45, 55, 72};
inline constexpr Color kFaintText{113, 124, 142};
inline constexpr double kTitleSize = 16.5;
inline constexpr double kTextSize = 12.0;
inline constexpr double kMargin = 20.0;

}  // namespace tumble::render::style
