// The bodies of a run: what they look like, their poses, and when they slept.
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "render/replay/body_numbers.hpp"
#include "render/replay/pose_track.hpp"
#include "render/style/palette.hpp"
#include "tumble/scene.hpp"
#include "tumble/scene_world.hpp"

namespace tumble::render {

class BodyTracks {
public:
    BodyTracks(const Scene& scene, double pose_quantum, const Colors& colors)
        : palette_(scene, colors), quantum_(pose_quantum) {}

    void record(const SceneWorld& built, std::uint64_t step);

    std::size_t pose_count() const noexcept { return pose_count_; }

    // Of all bodies so far, also of those that were destroyed.
    const BodyNumbers& numbers() const noexcept { return numbers_; }

    // `shapes`: the different shapes, each with `points` and `radius`. `bodies`: `name`, `type` (0 static, 1 kinematic,
    // 2 dynamic), `shapes` ([shape, colour, 1 for a sensor]...), `from` and `count` of its steps, `base` (first
    // position), `center` of mass (body coordinates), `mass`, `asleep` (steps at which it fell asleep, awoke, ...).
    nlohmann::ordered_json shapes_json() const;
    nlohmann::ordered_json bodies_json() const;

    // x of each body in turn, then y, then the angle: sequences of one kind compress better together.
    std::string pose_bytes() const;

private:
    struct DrawnShape {
        std::size_t shape = 0;  // in shapes_
        Color fill;
        bool is_sensor = false;
    };
    struct Track {
        std::string name;
        BodyType type{};
        std::vector<DrawnShape> shapes{};
        std::uint64_t from = 0;
        DVec2 center;
        double mass = 0.0;
        PoseTrack poses;
        std::vector<std::uint64_t> asleep{};
    };

    void add(const SceneWorld& built, std::size_t number, std::uint64_t step);
    std::size_t shape_number(const Shape& shape);

    Palette palette_;
    double quantum_;
    std::vector<Track> tracks_;  // [built.bodies.size()]
    BodyNumbers numbers_;
    std::vector<Shape> shapes_;
    std::size_t ordinal_ = 0;  // of the newest body among the copies of its source
    std::size_t pose_count_ = 0;
};

}  // namespace tumble::render
