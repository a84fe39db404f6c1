// Where the joints of a run are drawn: the anchors in the coordinates of their bodies, which change only by events.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "render/replay/body_numbers.hpp"
#include "tumble/scene_world.hpp"

namespace tumble::render {

class JointTracks {
public:
    explicit JointTracks(double pose_quantum) : tolerance_(pose_quantum) {}

    void record(const SceneWorld& built, std::uint64_t step, const BodyNumbers& body_numbers);

    // For each joint with anchors between bodies of the scene: `name`, `a` and `b` (numbers of bodies), `wheels` of a
    // pulley (world coordinates), and `spans`: [from, until, x and y of the anchor in A, in B], `until` not included.
    nlohmann::ordered_json to_json() const;

private:
    struct Span {
        std::uint64_t from = 0, until = 0;
        DVec2 a, b;  // body coordinates
    };
    struct Track {
        std::string name;
        std::uint32_t a = 0, b = 0;
        std::vector<DVec2> wheels{};
        std::vector<Span> spans{};
    };

    void append(Track& track, std::uint64_t step, DVec2 a, DVec2 b) const;

    double tolerance_;
    std::vector<Track> tracks_;  // [built.joints.size()]
};

}  // namespace tumble::render
