// The states of a scene that Box2D 2.4.1 simulates, as `diff` reads those of tumble.
#pragma once

#include <string>
#include <vector>

#include "reference/box2d/b2_world.hpp"
#include "tools/diff/scene_states.hpp"

namespace tumble::tools {

class Box2dStates final : public SceneStates {
public:
    // Throws as build_world().
    explicit Box2dStates(const Scene& scene);

    // Throws SimulationDiverged if a body is not finite in Box2D.
    bool next(StepStates& states) override;

    // Tumble's world of the scene, which is not simulated: its bodies are where those of Box2D are.
    const SceneWorld* built() const override { return &shown_; }

    // What Box2D leaves out of the scene, one line each.
    std::vector<std::string> notes() const;

private:
    void show();

    SceneWorld shown_;
    reference::B2World world_;
    std::uint64_t step_ = 0, last_step_ = 0;
    bool started_ = false;
};

}  // namespace tumble::tools
