// The camera of a run's frames: its view, and from which step on it is another one.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "render/replay/body_numbers.hpp"
#include "tumble/render.hpp"

namespace tumble::render {

class CameraTrack {
public:
    // `camera` is that of the frame that shows the world's present state.
    void record(const Camera& camera, const World& world, std::uint64_t step, const BodyNumbers& body_numbers);

    // For each view [from, follows, x, y, height]: the first step, the number of the body that the camera follows or
    // -1, and the center in world coordinates, or if it follows a body its offset from that body's position; m.
    nlohmann::ordered_json to_json() const;

private:
    struct View {
        int follows = -1;
        DVec2 center;  // or the offset
        double height = 0.0;
        bool operator==(const View&) const = default;
    };
    struct Span {
        std::uint64_t from = 0;
        View view;
    };

    std::vector<Span> spans_;
};

}  // namespace tumble::render
