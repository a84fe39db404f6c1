// Which file each entry of a scene comes from, if the scene includes others.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace tumble::scene {

struct IncludedLocation {
    std::string include;  // pointer of the entry that includes the file
    std::string name;     // "/bodies/1/shapes/0 of parts/car.json"
};

class IncludedParts {
public:
    // The entries of `list` ("/bodies") from `first` up to the `first` of the next call are those of `file`.
    void add(std::string list, std::size_t first, std::string include, std::string file);

    // Empty for an entry of the scene's own text.
    std::optional<IncludedLocation> find(const std::string& pointer) const;

private:
    struct Part {
        std::string list;
        std::size_t first = 0;
        std::string include;
        std::string file;
    };

    std::vector<Part> parts_;
};

}  // namespace tumble::scene
