// What identifies a failure of a scene, so that a smaller scene can be asked whether it fails the same.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tumble/scene_run.hpp"

namespace tumble::tools {

// One thing that fails. Two scenes fail the same if the texts are equal.
struct Failure {
    std::string text;        // "'crate' is inside [0, 0] to [2, 3] at the end: it is at [#, #], on the right"
    std::uint64_t step = 0;  // that decided it
    int claim = -1;          // its index in Scene::expect; -1: the scene does not come to its end
};

// Simulates the scene: its failed claims in their order, or the error that ends it. Claims that almost every other
// scene fails (`state_hash`, `picture`), and those on the wall clock, do not count. With `any_body` the names in
// findings are masked. Does not throw.
std::vector<Failure> find_failures(const Scene& scene, bool any_body);

// The text with # in place of each number that is not a part of a name: "the height is 0.31 m" and "body[12]".
std::string with_masked_numbers(std::string_view text);

// The text with * in place of each name in quotes: "'*' and '*' overlap".
std::string with_masked_names(std::string_view text);

// On which side of the values that the claim allows the finding is: ", below", ", on the right". Empty if the claim
// allows no range and no box.
std::string side_of(const SceneExpectation& claim, const std::string& finding);

// The claim and its result that a Failure of `claim` is about, by simulating the scene again.
ExpectationResult result_of_claim(const Scene& scene, int claim);

}  // namespace tumble::tools
