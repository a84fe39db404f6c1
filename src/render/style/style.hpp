// The widths and sizes of a frame, the same in every theme. Lengths are pixels at 720 rows (see View::detail).
#pragma once

namespace tumble::render::style {

inline constexpr double kInstanceShade = 0.10;  // largest change in lightness among copies of a body

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

inline constexpr double kHatchWidth = 1.0;
inline constexpr double kHatchSpacing = 12.0;  // across the lines
inline constexpr double kHatchOpacity = 0.45;  // of the colour of the outline
inline constexpr double kShadowRight = 5.0;    // how far a shadow is from its body
inline constexpr double kShadowDown = 6.0;

inline constexpr double kRope = 2.6;  // width of a rope

inline constexpr double kTitleSize = 16.5;
inline constexpr double kTextSize = 12.0;
inline constexpr double kMargin = 20.0;

}  // namespace tumble::render::style
