// Times scenes of Box2D v3's benchmark by its own program, which Box2D's source builds as `benchmark`.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tumble::tools {

class V3Program {
public:
    // Asks the program for its scenes. Throws InputError if it does not start, or is not that program.
    explicit V3Program(const std::filesystem::path& program);

    const std::filesystem::path& path() const noexcept { return program_; }
    bool has(const std::string& scene) const;

    struct Run {
        int steps = 0;
        double ms = 0.0;  // wall-clock time per step
    };

    // A run of a scene that it has, from the initial state, on so many threads, 0: one for each processor. Throws
    // InputError if the program fails.
    Run run(const std::string& scene, int threads) const;

private:
    std::string output_of(const std::vector<std::string>& arguments) const;

    std::filesystem::path program_;
    std::vector<std::string> scenes_;
};

}  // namespace tumble::tools
