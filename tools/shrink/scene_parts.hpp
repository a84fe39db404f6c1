// A scene as a JSON document, and the parts of it that can be removed or made simpler.
//
// A document is the canonical text of a valid scene without includes and random numbers, read as JSON. Its parts are
// named by JSON pointers, in the order of the document.
#pragma once

#include <nlohmann/json.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "tumble/scene.hpp"

namespace tumble::tools {

using SceneJson = nlohmann::ordered_json;
using Pointer = SceneJson::json_pointer;

// The document of a scene. Throws as to_json().
SceneJson document_of(Scene scene);

// The parts of one kind.
enum class PartKind { claims, events, joints, bodies, shapes, points, materials, keys };
inline constexpr PartKind kPartKinds[] = {PartKind::claims, PartKind::events, PartKind::joints,    PartKind::bodies,
                                          PartKind::shapes, PartKind::points, PartKind::materials, PartKind::keys};

// Points are those of chains, outlines and polygons. Keys are those whose absence means a default, and that say neither
// what or where a body is, nor how long the scene lasts, nor what it claims.
std::vector<Pointer> parts_of(const SceneJson& document, PartKind kind);

// "bodies".
const char* name_of(PartKind kind);

// The document without these parts, which are in its order.
SceneJson without(const SceneJson& document, const std::vector<Pointer>& parts);

// The canonical text of the document, or nothing if it is not a valid scene.
std::optional<std::string> valid_text(const SceneJson& document);

// The same after removing from it what names a body, joint or material that it does not have: joints, events, claims,
// the camera's `follow`, its key frames and notes, and the `material` of shapes.
std::optional<std::string> repaired_text(SceneJson& document);

// The numbers of copies of repeaters that are larger than 1, and the `repeat` itself before its numbers.
struct Repeat {
    Pointer repeat;
    std::vector<Pointer> counts;
};
std::vector<Repeat> repeats_of(const SceneJson& document);

// The document of this scene with the copies of a repeated body, /bodies/INDEX, as bodies of their own, which have the
// same names and poses. Throws as build_world().
SceneJson with_single_copies(const SceneJson& document, const Scene& scene, std::size_t index);

// The numbers with a fraction in the world, the materials, bodies, joints and events, without those of time.
std::vector<Pointer> fractions_of(const SceneJson& document);

// The number with `digits` significant digits, but never coarser than the nearest whole number.
double rounded(double number, int digits);

struct SceneSize {
    std::size_t bodies = 0, joints = 0;  // with copies
    std::size_t shapes = 0, events = 0, claims = 0;
    double duration = 0.0;  // s
    std::size_t bytes = 0;  // of the canonical text
};
SceneSize size_of(const Scene& scene);

}  // namespace tumble::tools
