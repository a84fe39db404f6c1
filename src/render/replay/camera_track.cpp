#include "render/replay/camera_track.hpp"

#include <nlohmann/json.hpp>

#include <optional>

namespace tumble::render {

void CameraTrack::record(const Camera& camera, const World& world, std::uint64_t step,
                         const BodyNumbers& body_numbers) {
    View view{-1, camera.center, camera.height};
    const std::optional<std::uint32_t> followed = find_number(body_numbers, camera.follows);
    if (followed && world.is_valid(camera.follows)) view = {static_cast<int>(*followed), camera.offset, camera.height};
    if (spans_.empty() || spans_.back().view != view) spans_.push_back({step, view});
}

nlohmann::ordered_json CameraTrack::to_json() const {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const auto& [from, view] : spans_)
        list.push_back({from, view.follows, view.center.x, view.center.y, view.height});
    return list;
}

}  // namespace tumble::render
