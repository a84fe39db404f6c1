// The states of all bodies of a scene's world, by whatever it is moved: tumble, or another engine.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "tools/diff/body_states.hpp"
#include "tumble/scene_run.hpp"

namespace tumble::tools {

// The numbers are x, y, the normal's x and y, separation and impulse, as text.
std::string contact_text(const std::string& a, const std::string& b, const std::array<std::string, 6>& numbers);

class SceneStates : public StateSource {
public:
    explicit SceneStates(Scene scene);

    const Scene* scene() const final { return &scene_; }
    double energy() const final;
    std::vector<std::string> contacts_of(const std::string& body) final;

protected:
    // The states of the bodies in built().
    void list(StepStates& states, std::uint64_t step, double time);

private:
    std::uint64_t shapes_of(const SceneInstance& body);

    Scene scene_;
    Expression energy_;
    std::map<std::size_t, std::uint64_t> shapes_;  // by SceneInstance::source
};

}  // namespace tumble::tools
