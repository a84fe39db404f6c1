// Where the entries of a scene that came from other files have their place.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace tumble::scene {

struct IncludedPlace {
    std::string include;  // pointer of the entry that includes the file
    std::string name;     // "/bodies/1/shapes/0 of parts/car.json"
};

class IncludedParts {
public:
    // The entries `first`, first + 1... of `list` ("/bodies") up to those added next are those of `file`.
    void add(std::string list, std::size_t first, std::string include, std::string file);

    // Nothing for what is in the text itself.
    std::optional<IncludedPlace> find(const std::string& pointer) const;

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
