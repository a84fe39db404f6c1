// Makes a scene smaller while it fails in the same way.
//
// First it removes claims, events, bodies, joints, shapes, points of outlines, and materials, each kind by delta
// debugging; what names a removed body goes with it. Then it lowers the numbers of copies, or writes copies as single
// bodies if that lets some of them go, shortens the run to the step
// of the failure, drops keys that need not differ from their defaults, and rounds numbers. Last it tries again to
// remove each single part, until none can be removed. It follows Regehr et al., "Test-Case Reduction for C Compiler
// Bugs", PLDI 2012, in that every candidate is a valid input.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "tools/shrink/candidates.hpp"
#include "tools/shrink/failure.hpp"
#include "tools/shrink/scene_parts.hpp"
#include "tumble/scene.hpp"

namespace tumble::tools {

class Shrinker {
public:
    // Receives the canonical text of each smaller scene.
    using Keep = std::function<void(const std::string& text)>;
    // Receives what a stage has changed: "bodies: 122 -> 3".
    using Report = std::function<void(const std::string& text)>;

    // The canonical text of a scene, which fails so. Bodies of `kept_names` are not removed.
    Shrinker(const std::string& text, Failure failure, std::vector<std::string> kept_names, Candidates& candidates,
             Keep keep, Report report);

    // Throws SearchInterrupted and FileError.
    void shrink();

    const Scene& scene() const { return scene_; }
    std::uint64_t step() const { return step_; }  // that decided the failure; 0 if it is not known

private:
    bool remove(PartKind kind, bool singly);
    bool remove_structure(bool singly);
    bool lower_repeats();
    void separate_copies();
    bool separate_copies_of(std::size_t body);
    bool shorten();
    bool shorten_to(std::uint64_t step);
    bool search_shorter();
    void round_numbers();
    std::vector<Pointer> removable_parts(PartKind kind) const;
    std::optional<std::string> smaller_text(SceneJson document, PartKind kind) const;
    std::size_t try_first(std::size_t count, const Candidates::Make& make);
    void accept(const std::string& text);

    Failure failure_;
    std::vector<std::string> kept_names_;
    Candidates& candidates_;
    Keep keep_;
    Report report_;
    Scene scene_;
    SceneJson document_;  // of scene_
    std::uint64_t step_ = 0;
};

}  // namespace tumble::tools
