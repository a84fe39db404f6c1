// JSON pointers (RFC 6901).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tumble::scene {

// A step on the way from the root to a value, chained on the stack of the reader: nothing is built until an error
// needs the pointer.
struct Place {
    const Place* parent = nullptr;
    std::string_view key;   // of an object, or
    std::size_t index = 0;  // of an array, if key.data() is null
};

inline Place child(const Place& parent, std::string_view key) { return {&parent, key, 0}; }
inline Place child(const Place& parent, std::size_t index) { return {&parent, {}, index}; }

// "" for the root, "/bodies/3/name"; ~ and / in keys are escaped as ~0 and ~1.
std::string pointer_to(const Place& place);

// `pointer` with one more step.
std::string append_key(const std::string& pointer, std::string_view key);

// The unescaped steps of a pointer. It must be empty or start with '/'.
std::vector<std::string> split_pointer(std::string_view pointer);

// True if `pointer` is `ancestor` or lies below it.
bool is_within(std::string_view pointer, std::string_view ancestor);

}  // namespace tumble::scene
