// A scene whose names are looked up, whose repeaters are expanded and whose shapes and joints are made.
#pragma once

#include <vector>

#include "scene/model/body_plan.hpp"
#include "scene/model/joint_copies.hpp"
#include "scene/model/names.hpp"
#include "scene/model/place_copies.hpp"

namespace tumble::scene {

struct ResolvedScene {
    explicit ResolvedScene(const Scene& scene) : body_names(scene), joint_names(scene) {}

    BodyNames body_names;
    JointNames joint_names;
    std::vector<BodyPlan> plans;                 // [Scene::bodies]
    std::vector<PlacedBody> placed;              // [built bodies]: the copies of the first body, then of the second...
    std::vector<std::vector<JointCopy>> joints;  // [Scene::joints][copy]
    bool bodies_unread = false;                  // the reader found errors in bodies: names and copies may be missing
};

}  // namespace tumble::scene
