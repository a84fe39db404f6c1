// Large valid scenes, each with a small core that fails.
#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace tumble::test {

// The core is at the origin, and nothing else comes near it.
struct PlantedFailure {
    std::string title;
    std::vector<std::string> bodies, joints, events;  // of the core, as JSON
    std::string claim;                                // that fails; empty if there is none
    std::string command = "check";                    // --fails
    bool same_output = false;
    std::size_t most_bodies = 2;  // of the minimal scene
};

// Twenty.
const std::vector<PlantedFailure>& planted_failures();

// A scene of about a hundred bodies, with joints, events and claims that hold, and this failure among them. Of other
// bodies there are at least 24.
nlohmann::json planted_scene(const PlantedFailure& failure, int other_bodies = 97);

}  // namespace tumble::test
