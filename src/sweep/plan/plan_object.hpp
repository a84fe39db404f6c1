// Reads the members of one JSON object of a plan, and reports those that are wrong or not known.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/json/diagnostics.hpp"
#include "scene/json/json.hpp"

namespace tumble::sweep {

// Members that are missing keep the value that the caller gives. Every error goes to the diagnostics.
class PlanObject {
public:
    // A value that is no object is an error, and has no members.
    PlanObject(const scene::Json& value, std::string pointer, scene::Diagnostics& diagnostics);

    // Reports the keys that were not asked for. To be called last.
    void finish();

    bool has(std::string_view key);
    // The member, or null.
    const scene::Json* find(std::string_view key);
    std::string pointer_to(std::string_view key) const;
    void error(std::string_view key, const std::string& message, const std::string& hint = "") const;

    bool flag(std::string_view key, bool otherwise);
    std::string text(std::string_view key, std::string otherwise = {});
    double number(std::string_view key, double lowest, double highest, double otherwise);
    // At most 2^53.
    std::uint64_t whole(std::string_view key, std::uint64_t lowest, std::uint64_t highest, std::uint64_t otherwise);
    // Two numbers.
    std::optional<std::pair<double, double>> pair(std::string_view key);
    // JSON texts of the elements of an array that is not empty.
    std::vector<std::string> values(std::string_view key);
    // One text, or an array of them that is not empty.
    std::vector<std::string> texts(std::string_view key);
    // One of the words; the first by default.
    std::string word(std::string_view key, const std::vector<std::string_view>& words);

private:
    const scene::Json& value_;
    std::string pointer_;
    scene::Diagnostics& diagnostics_;
    std::vector<std::string_view> known_;
};

}  // namespace tumble::sweep
