// A R.U.B.E. export of rows of bodies, as the editor writes it: floats as 8 hexadecimal digits, mass data of what the
// fixtures weigh.
#pragma once

#include <bit>
#include <cstdint>
#include <cstdio>
#include <random>
#include <string>

#include "tumble/math.hpp"

namespace tumble::test {

struct RubeExport {
    std::string text;
    int bodies = 0, fixtures = 0, joints = 0;
};

inline std::string hex_float(float value) {
    char digits[16];
    std::snprintf(digits, sizeof digits, "\"%08X\"", static_cast<unsigned>(std::bit_cast<std::uint32_t>(value)));
    return digits;
}

inline std::string hex_vector(Vec2 v) { return R"({"x": )" + hex_float(v.x) + R"(, "y": )" + hex_float(v.y) + "}"; }

// A static ground with a polygon, an edge and a chain; then `count` dynamic bodies of a box and a ball each, joined to
// the one before by each kind of joint in turn.
inline RubeExport make_rube_export(int count) {
    std::mt19937 random(5);
    const auto draw = [&](float low, float high) {
        return low + (high - low) * static_cast<float>(random() >> 8) * 0x1p-24f;
    };
    std::string bodies = R"({"type": 0, "name": "ground", "position": 0, "fixture": [
        {"polygon": {"vertices": {"x": [-9, 9, 9, -9], "y": [-2, -2, -1, -1]}}},
        {"edge": {"vertex1": {"x": -9, "y": 0}, "vertex2": {"x": -9, "y": 4}}},
        {"chain": {"vertices": {"x": [-20, -18, -16], "y": [0, 0, 1]}}}]})";
    std::string joints;
    for (int i = 1; i <= count; ++i) {
        const Vec2 half{draw(0.2f, 0.5f), draw(0.2f, 0.5f)};
        const float radius = draw(0.1f, 0.3f), side = draw(-0.5f, 0.5f), density = draw(0.5f, 4.0f);
        // In rows of 20: Box2D's floats round to 1e-6 m within 32 m of the origin.
        const int column = i % 20, row = i / 20;
        const Vec2 position{1.5f * static_cast<float>(column), draw(1.0f, 1.5f) + static_cast<float>(row)};
        // Of a box about the origin and a ball at (side, 0): I is about the origin.
        const double width = 2.0 * double{half.x}, height = 2.0 * double{half.y}, r = radius, x = side;
        const double box = double{density} * width * height, ball = double{density} * kPi * r * r;
        const double inertia = box * (width * width + height * height) / 12.0 + ball * (r * r / 2.0 + x * x);
        const std::string hx = hex_float(half.x), hy = hex_float(half.y), nx = hex_float(-half.x),
                          ny = hex_float(-half.y), weight = hex_float(density);
        bodies += R"(, {"type": 2, "awake": true, "name": "part)" + std::to_string(i) + R"(", "position": )" +
                  hex_vector(position) + R"(, "angle": )" + hex_float(draw(-3.0f, 3.0f)) + R"(, "massData-mass": )" +
                  hex_float(static_cast<float>(box + ball)) + R"(, "massData-center": )" +
                  hex_vector({static_cast<float>(ball * x / (box + ball)), 0.0f}) + R"(, "massData-I": )" +
                  hex_float(static_cast<float>(inertia)) + R"(, "fixture": [{"density": )" + weight +
                  R"(, "polygon": {"vertices": {"x": [)" + nx + ", " + hx + ", " + hx + ", " + nx + R"(], "y": [)" +
                  ny + ", " + ny + ", " + hy + ", " + hy + R"(]}}}, {"density": )" + weight +
                  R"(, "circle": {"radius": )" + hex_float(radius) + R"(, "center": )" + hex_vector({side, 0.0f}) +
                  "}}]}";
        if (i == 1) continue;
        const char* const kinds[] = {
            R"("revolute", "enableLimit": true, "lowerLimit": -1, "upperLimit": 1)",
            R"("prismatic", "localAxis1": {"x": 0, "y": 2}, "enableMotor": true, "motorSpeed": 1, "maxMotorForce": 9)",
            R"("distance", "length": 1.5, "frequency": 2, "dampingRatio": 0.5)", R"("weld", "refAngle": "3FC90FDB")",
            R"("wheel", "localAxisA": {"x": 0, "y": 1}, "springFrequency": 4, "springDampingRatio": 0.7)"};
        joints += std::string(i == 2 ? "" : ", ") + R"({"type": )" + kinds[i % 5] + R"(, "bodyA": )" +
                  std::to_string(i - 1) + R"(, "bodyB": )" + std::to_string(i) + R"(, "anchorA": )" +
                  hex_vector({draw(0.3f, 0.8f), draw(-0.2f, 0.2f)}) + R"(, "anchorB": )" +
                  hex_vector({draw(-0.8f, -0.3f), draw(-0.2f, 0.2f)}) + "}";
    }
    return {R"({"gravity": {"x": 0, "y": "C11CF5C3"}, "allowSleep": true, "body": [)" + bodies + R"(], "joint": [)" +
                joints + "]}",
            count + 1, 3 + 2 * count, count - 1};
}

}  // namespace tumble::test
