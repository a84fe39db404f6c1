#include "scene/json/included_parts.hpp"

#include <charconv>
#include <utility>

#include "scene/json/pointer.hpp"

namespace tumble::scene {

namespace {

// "/bodies/12/shapes/0" in the list "/bodies": index 12, rest "/shapes/0".
struct Indexed {
    std::size_t index = 0;
    std::string rest;
};

std::optional<Indexed> index_in(const std::string& list, const std::string& pointer) {
    if (!is_within(pointer, list) || pointer.size() == list.size()) return std::nullopt;
    const char* const end = pointer.data() + pointer.size();
    Indexed found;
    const std::from_chars_result parsed = std::from_chars(pointer.data() + list.size() + 1, end, found.index);
    if (parsed.ec != std::errc{}) return std::nullopt;
    found.rest.assign(parsed.ptr, end);
    return found;
}

}  // namespace

void IncludedParts::add(std::string list, std::size_t first, std::string include, std::string file) {
    parts_.push_back({std::move(list), first, std::move(include), std::move(file)});
}

std::optional<IncludedLocation> IncludedParts::find(const std::string& pointer) const {
    std::optional<IncludedLocation> found;
    for (const Part& part : parts_) {
        const std::optional<Indexed> entry = index_in(part.list, pointer);
        if (!entry || entry->index < part.first) continue;
        const std::string index = std::to_string(entry->index - part.first);
        found = {part.include, part.list + '/' + index + entry->rest + " of " + part.file};
    }
    return found;
}

}  // namespace tumble::scene
