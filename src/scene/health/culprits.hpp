// The findings of one check: of each kind of body or joint the worst one, and how many others there are.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <vector>

#include "tumble/scene_run.hpp"

namespace tumble::scene {

// The bodies or joints at fault, by their indices in SceneWorld::bodies or SceneWorld::joints (`members`), and the
// entries of the scene that they are copies of (`sources`).
struct Culprit {
    std::vector<std::size_t> members;
    std::vector<std::size_t> sources;
};

class Culprits {
public:
    // Whether a finding of this severity is the worst of its kind so far: only then is its text needed. Counts the
    // culprit.
    bool is_worst(const Culprit& culprit, double severity) {
        Kind& kind = kinds_[culprit.sources];
        kind.members.insert(culprit.members);
        if (severity <= kind.severity) return false;
        kind.severity = severity;
        return true;
    }

    // To be called after is_worst() has answered true.
    void set(const Culprit& culprit, HealthFinding finding) { kinds_[culprit.sources].worst = std::move(finding); }

    // Appends them, the worst first.
    void append_to(std::vector<HealthFinding>& findings) const;

private:
    struct Kind {
        double severity = -1.0;
        HealthFinding worst;
        std::set<std::vector<std::size_t>> members;
    };

    std::map<std::vector<std::size_t>, Kind> kinds_;
};

}  // namespace tumble::scene
